// SPDX-License-Identifier: MIT
//
// Finds the sites near enough to matter to a star, in a tree of boxes.
//
// How near a site w must be depends on its own metric: with |w|_v the metric distance of w as v
// sees it and sigma^2 the largest eigenvalue of M_w^-1 M_v, or 1 if that is more, a site with
//   |w|_v > (1 + sigma) reach
// is accepted in no gap of the star (docs/math/certificate.md, section 4.3). A box bounds |w|_v
// from below and sigma from above for all its sites at once; rounding only ever keeps a site.
//
// The mesher has an index with the same descent by the same lemma (mesh/search/site_index). The two
// are apart deliberately: the auditor must share no code with what it judges.
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
  // visits for any of them. False, and nothing is known, where that would not be worth while:
  // unless all reaches are finite and the stars' metrics much the same.
  bool gather(const std::vector<reaching>& stars, std::vector<std::size_t>& leaves) const;
  // Visits as the function without leaves does, for one of the stars they were gathered for.
  template <class Visit>
  void visit_near(const std::vector<std::size_t>& leaves, const site& v, double reach,
                  const Visit& visit) const;

 private:
  static constexpr std::size_t leaf_size = 8;
  static constexpr std::size_t most_depth = 64;  // nodes are halved

  // The sites order_[first .. last), in a box. Every metric M_w among them is at least
  // inverse^-1 / spread_squared, as quadratic forms.
  struct node {
    point low, high;
    metric_tensor inverse;
    double determinant_below = 0;  // of `inverse`
    double spread_squared = 0;     // infinite where not known
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the left child follows its parent; no right child: a leaf
  };
  // One star, or several: their places are in the box, the metric M of each is at least `metric` /
  // spread_squared and at most spread_squared `metric`, and `reach`, in `metric`, is that of all.
  struct centre {
    point low, high;
    metric_tensor metric;
    double determinant_below = 0, reach = 0, spread_squared = 1;
  };

  void build(std::size_t first, std::size_t last, const std::vector<site>& sites);
  void bound_leaf(node& n, const std::vector<site>& sites) const;
  void bound_parent(node& n, const node& left, const node& right) const;
  static centre centre_of(const site& v, double reach);
  static std::optional<centre> centre_of(const std::vector<reaching>& stars);
  // For all w of the node and v of the centre, |w - v|^2 in its metric is at least squared_least /
  // square_above, if that is positive.
  struct approach {
    double squared_least = 0, square_above = 0;
    bool is_beyond(double squared_limit) const;
  };
  static approach approach_of(const node& n, const centre& v);
  static double trace_above(const node& n, const centre& v);  // infinite where not known
  // Returns (1 + sigma) reach for all sites of the node, from above; infinite where not known.
  static double limit(const node& n, const centre& v);
  // Its square, not as near but without a root.
  static double rough_squared_limit(const node& n, const centre& v);
  static bool too_far(const node& n, const centre& v);
  // True if |q - v|_v is certainly above the limit.
  static bool beyond(const point& q, const centre& v, double limit);
  template <class Visit>
  void visit_leaf(const node& n, const centre& v, const Visit& visit) const;
  // Calls visit(leaf) for each that is not too far.
  template <class Visit>
  void visit_leaves(const centre& c, const Visit& visit) const;

  std::vector<vertex_index> order_;
  std::vector<std::size_t> groups_;
  std::vector<point> places_;  // in that order
  std::vector<node> nodes_;
};

template <class Visit>
void site_tree::visit_leaves(const centre& c, const Visit& visit) const {
  std::array<std::size_t, most_depth> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const std::size_t self = open[--waiting];
    const node& n = nodes_[self];
    if (too_far(n, c)) continue;
    if (n.right == 0) {
      visit(self);
      continue;
    }
    open[waiting++] = n.right;
    open[waiting++] = self + 1;
  }
}

template <class Visit>
void site_tree::visit_leaf(const node& n, const centre& v, const Visit& visit) const {
  const double most = limit(n, v);
  for (std::size_t i = n.first; i < n.last; ++i)
    if (!beyond(places_[i], v, most)) visit(order_[i]);
}

template <class Visit>
void site_tree::visit_near(const site& v, double reach, const Visit& visit) const {
  const centre c = centre_of(v, reach);
  visit_leaves(c, [&](std::size_t leaf) { visit_leaf(nodes_[leaf], c, visit); });
}

template <class Visit>
void site_tree::visit_near(const std::vector<std::size_t>& leaves, const site& v, double reach,
                           const Visit& visit) const {
  const centre c = centre_of(v, reach);
  for (const std::size_t leaf : leaves)
    if (!too_far(nodes_[leaf], c)) visit_leaf(nodes_[leaf], c, visit);
}

}  // namespace asterism::internal::audit_detail
