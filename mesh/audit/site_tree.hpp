// SPDX-License-Identifier: MIT
//
// Finds the sites near enough to matter to a star, in a tree of boxes.
//
// How near a site w must be depends on its own metric, and on the direction. With g any covector,
// |g|_v and |g|_w how long the two metrics find it (|g|_v^2 = g M_v^-1 g), a site with
//   g . (w - v) > (|g|_v + max(|g|_v, |g|_w)) reach
// is accepted in no gap of the star (docs/math/certificate.md, section 4.3). A box bounds the left
// side from below and the right one from above for all its sites at once; rounding only ever keeps
// a site. The covector is a free choice: two are tried.
//
// The mesher has an index with the same descent by a lemma of the same kind (mesh/search/
// site_index). The two are apart deliberately: the auditor must share no code with what it judges.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::audit_detail {

class site_tree {
 public:
  // Builds the tree of sites that are finite and positive definite, and that must outlive it.
  explicit site_tree(const std::vector<site>& sites);

  // Returns all sites, near ones near each other.
  const std::vector<vertex_index>& order() const { return order_; }
  // Returns where groups of neighbouring sites begin in that order, then the number of sites.
  const std::vector<std::size_t>& groups() const { return groups_; }

  // Calls visit(w) for each site that is not certainly too far from v, in an order that depends on
  // the sites alone; v itself may be among them. `reach` is R of the lemma, in the metric of v and
  // no less than each gap's; infinite: all sites.
  template <class Visit>
  void visit_near(const site& v, double reach, const Visit& visit) const;

  // The centre of a star, and how far it reaches.
  struct reaching {
    site v;
    double reach;
  };
  // Descends once for several stars: sets `leaves` to those nodes that hold all that visit_near
  // visits for any of them, but for leaves that end before `from` in the order. False, and nothing
  // is known, where that would not be worth while: unless all reaches are finite and the stars'
  // metrics much the same.
  bool gather(const std::vector<reaching>& stars, std::vector<std::size_t>& leaves,
              std::size_t from = 0) const;
  // Visits as the function without leaves does, for one of the stars they were gathered for, from a
  // place in the order on.
  template <class Visit>
  void visit_near(const std::vector<std::size_t>& leaves, const site& v, double reach,
                  const Visit& visit, std::size_t from = 0) const;

  // True if w is certainly too far from v.
  static bool is_too_far(const site& v, double reach, const site& w);

 private:
  static constexpr std::size_t leaf_size = 8;
  static constexpr std::size_t most_depth = 64;  // nodes are halved

  // The sites order_[first .. last), in a box. Every metric M_w among them is at least
  // inverse^-1 / spread_squared, as quadratic forms.
  struct node {
    point low, high;
    metric_tensor inverse;
    double spread_squared = 0;  // infinite where not known
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the left child follows its parent; no right child: a leaf
  };
  // One star, or several: their places are in the box, the metric M of each is at least `metric` /
  // spread_squared and at most spread_squared `metric`. `reach` is that of all, each in the star's
  // own metric, times the root of spread_squared.
  struct centre {
    point low, high;
    metric_tensor metric;
    double reach = 0, spread_squared = 1;
  };
  // All w - v.
  struct offset_box {
    point low, high;
  };
  // All M_w^-1 are at most `factor` times this tensor.
  struct inverse_bound {
    metric_tensor tensor;
    double factor = 0;  // infinite where not known
  };
  // Separates by one covector g = M h, M the centre's metric.
  struct separation {
    double least = 0;          // at most g . (w - v); not positive: nothing is known
    double own_squared = 0;    // at least |h|^2 in M
    double other_squared = 0;  // at least |g|_w^2 / spread_squared
    bool is_beyond(double reach) const;
  };

  void build(std::size_t first, std::size_t last);
  void bound_leaf(node& n) const;
  void bound_parent(node& n, const node& left, const node& right) const;
  static centre centre_of(const site& v, double reach);
  static std::optional<centre> centre_of(const std::vector<reaching>& stars);
  static separation separation_along(const point& h, const offset_box& to, const centre& v,
                                     const inverse_bound& inverse);
  static bool too_far(const offset_box& to, const centre& v, const inverse_bound& inverse);
  static bool too_far_from_both(const point& c, const offset_box& to, const centre& v,
                                const inverse_bound& inverse);
  static bool too_far(const node& n, const centre& v);
  static bool too_far(const site& w, const centre& v);
  // True if a site with the metric m is, at d from the one star v; of 1 / det m an upper bound.
  static bool too_far(const point& d, const metric_tensor& m, double inverse_determinant,
                      const centre& v);
  // Returns the square of a distance from v beyond which no site of the node matters, whatever its
  // direction, though nearer ones may not either; infinite where none is known.
  static double far_squared(const node& n, const centre& v);
  // True if all of the node's box is certainly farther than that from the one star v, as one of the
  // axes shows.
  static bool is_beside(const node& n, const centre& v, double far_squared);
  // True if |d|^2 is certainly more than that, d as the metric measures.
  static bool is_farther(const point& d, const metric_tensor& m, double far_squared);
  template <class Visit>
  void visit_leaf(const node& n, const centre& v, std::size_t from, const Visit& visit) const;
  // Calls visit(leaf) for each that is not too far and does not end before `from` in the order.
  template <class Visit>
  void visit_leaves(const centre& c, std::size_t from, const Visit& visit) const;

  const std::vector<site>& sites_;
  std::vector<vertex_index> order_;
  std::vector<std::size_t> groups_;
  std::vector<point> places_;                 // in that order
  std::vector<double> inverse_determinants_;  // upper bounds, in that order
  std::vector<node> nodes_;
};

template <class Visit>
void site_tree::visit_leaves(const centre& c, std::size_t from, const Visit& visit) const {
  std::array<std::size_t, most_depth> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const std::size_t self = open[--waiting];
    const node& n = nodes_[self];
    if (n.last <= from || too_far(n, c)) continue;
    if (n.right == 0) {
      visit(self);
      continue;
    }
    open[waiting++] = n.right;
    open[waiting++] = self + 1;
  }
}

template <class Visit>
void site_tree::visit_leaf(const node& n, const centre& v, std::size_t from,
                           const Visit& visit) const {
  const double far = far_squared(n, v);
  if (is_beside(n, v, far)) return;
  for (std::size_t i = n.first < from ? from : n.first; i < n.last; ++i) {
    const point d{places_[i].x - v.low.x, places_[i].y - v.low.y};
    if (is_farther(d, v.metric, far)) continue;
    if (!too_far(d, sites_[order_[i]].metric, inverse_determinants_[i], v)) visit(order_[i]);
  }
}

template <class Visit>
void site_tree::visit_near(const site& v, double reach, const Visit& visit) const {
  const centre c = centre_of(v, reach);
  visit_leaves(c, 0, [&](std::size_t leaf) { visit_leaf(nodes_[leaf], c, 0, visit); });
}

template <class Visit>
void site_tree::visit_near(const std::vector<std::size_t>& leaves, const site& v, double reach,
                           const Visit& visit, std::size_t from) const {
  const centre c = centre_of(v, reach);
  for (const std::size_t leaf : leaves)
    if (nodes_[leaf].last > from) visit_leaf(nodes_[leaf], c, from, visit);
}

}  // namespace asterism::internal::audit_detail
