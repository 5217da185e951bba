// SPDX-License-Identifier: MIT
//
// Finds the sites near enough to matter to a star, in a tree of boxes.
//
// How near a site w must be depends on its own metric, and on the direction: for each covector g, a
// star's extent (audit/star_extent.hpp) bounds g . (w - v) by a function of the length of g in w's
// metric. Of a box of sites the tree keeps the least and greatest values of four covectors, x, y,
// x + y and x - y, the greatest length of each, and a lower bound of all metrics, by which other
// covectors are measured: each star, or group of stars, has one of its own. Rounding only ever
// keeps a site.
//
// The mesher has an index with the same descent by a lemma of the same kind (mesh/search/
// site_index). The two are apart deliberately: the auditor must share no code with what it judges.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/star_extent.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::audit_detail {

class site_tree {
 public:
  // Builds the tree of sites that are finite and positive definite.
  explicit site_tree(const std::vector<site>& sites);

  // Takes the places and metrics of the same sites after changes, and bounds the nodes with a
  // changed site again. The order stays: it suits small moves.
  void take_sites(const std::vector<site>& sites);

  // Returns the numbers of all sites, ordered so that sites near each other are close in the list.
  const std::vector<vertex_index>& order() const { return order_; }
  // Returns the starts of the groups of neighbouring sites in order(), then the number of sites.
  const std::vector<std::size_t>& groups() const { return groups_; }

  // Calls visit(w) for each site that is not certainly too far from the star, in an order that
  // depends on the sites alone; the star's centre may be among them. A visit that returns false
  // ends it.
  template <class Visit>
  void visit_near(const star_extent& star, const Visit& visit) const {
    visit_leaves(star, 0, [&](std::size_t leaf) { return visit_leaf(leaf, star, 0, visit); });
  }

  // True unless the extents along the axes alone show that no site matters to gaps of this reach, a
  // length in v's metric. Takes a part of the time of a search.
  bool may_reach(const site& v, double reach) const;

  // Descends once for several stars: sets `leaves` to those that contain all sites which visit_near
  // visits for any of them, except leaves that end before `from` in the order.
  void gather(std::span<const star_extent> stars, std::vector<std::size_t>& leaves,
              std::size_t from = 0) const;
  // Visits the sites that visit_near would visit without `leaves`, for one of the stars for which
  // these were gathered: those from position `from` of the order on.
  template <class Visit>
  void visit_near(const std::vector<std::size_t>& leaves, const star_extent& star,
                  const Visit& visit, std::size_t from = 0) const {
    for (const std::size_t leaf : leaves)
      if (nodes_[leaf].last > from && !visit_leaf(leaf, star, from, visit)) return;
  }

 private:
  static constexpr std::size_t leaf_size = 8;
  static constexpr std::size_t most_depth = 64;  // nodes are halved
  // The sites order_[first .. last).
  struct node {
    by_covector least, greatest;  // values of the covectors
    by_covector length;           // no less than in the metric of any of the sites
    // Every metric M_w among them is at least inverse^-1 / spread_squared, as quadratic forms.
    metric_tensor inverse;
    double spread_squared;  // infinite where not known
    std::uint32_t first, last;
    std::uint32_t right;  // the left child follows its parent; no right child: a leaf
  };

  // Returns the number of nodes of a tree with this number of sites, at least one.
  static std::size_t node_count(std::size_t sites);
  void build(const std::vector<site>& sites, std::size_t self, std::size_t first, std::size_t last);
  void halve(const std::vector<site>& sites, std::size_t first, std::size_t middle,
             std::size_t last);
  // Bounds the rounding errors of covectors' values, from the greatest coordinates of all sites.
  void bound_roundings(const std::vector<site>& sites);
  // Copies the places and metrics of a leaf's sites from the list of all. Returns whether one
  // differs from its former ones.
  bool take_sites_of_leaf(const node& n, const std::vector<site>& sites);
  void bound_leaf(node& n) const;
  void bound_metrics_of_leaf(node& n) const;
  static void bound_parent(node& n, const node& left, const node& right);
  // True if the star's own covector certainly separates all sites of the node from it, or one site.
  static bool is_beyond(const node& n, const star_extent& star);
  static bool is_beyond(const site& w, const star_extent& star);
  // Calls visit(argument). Returns false if visit returns false, and true if it returns nothing.
  template <class Visit, class Argument>
  static bool goes_on(const Visit& visit, Argument argument) {
    if constexpr (std::is_same_v<std::invoke_result_t<Visit, Argument>, bool>) {
      return visit(argument);
    } else {
      visit(argument);
      return true;
    }
  }
  template <class Visit>
  bool visit_leaf(std::size_t leaf, const star_extent& star, std::size_t from,
                  const Visit& visit) const;
  // Visits, from the first to the last, the leaves that are not excluded and not below an excluded
  // node. Ends once visit(leaf) returns false.
  template <class Excludes, class Visit>
  void descend(const Excludes& excludes, const Visit& visit) const;
  // Calls visit(leaf) for each leaf that is not too far and does not end before `from` in the
  // order.
  template <class Visit>
  void visit_leaves(const star_extent& stars, std::size_t from, const Visit& visit) const;

  std::vector<vertex_index> order_;
  std::vector<std::size_t> groups_;
  std::vector<site> sites_;  // in that order
  std::vector<node> nodes_;
  double lost_ = 0;  // at least the errors of values at sites
};

template <class Excludes, class Visit>
void site_tree::descend(const Excludes& excludes, const Visit& visit) const {
  std::array<std::size_t, most_depth> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const std::size_t self = open[--waiting];
    const node& n = nodes_[self];
    if (excludes(n)) continue;
    if (n.right == 0) {
      if (!goes_on(visit, self)) return;
      continue;
    }
    open[waiting++] = n.right;
    open[waiting++] = self + 1;
  }
}

template <class Visit>
void site_tree::visit_leaves(const star_extent& stars, std::size_t from, const Visit& visit) const {
  const auto excludes = [&](const node& n) {
    return n.last <= from || stars.box_for(n.length, lost_).excludes(n.least, n.greatest) ||
           is_beyond(n, stars);
  };
  descend(excludes, visit);
}

template <class Visit>
bool site_tree::visit_leaf(std::size_t leaf, const star_extent& star, std::size_t from,
                           const Visit& visit) const {
  const node& n = nodes_[leaf];
  const star_extent::box box = star.box_for(n.length, lost_);
  if (box.excludes(n.least, n.greatest)) return true;
  for (std::size_t i = n.first < from ? from : n.first; i < n.last; ++i)
    if (!box.excludes(sites_[i].position) && !is_beyond(sites_[i], star) &&
        !goes_on(visit, order_[i]))
      return false;
  return true;
}

inline bool site_tree::is_beyond(const node& n, const star_extent& star) {
  using roundings::step;
  const point &g = star.own(), &v = star.v().position;
  const double low_x = n.least.axes[0] - v.x, high_x = n.greatest.axes[0] - v.x,
               low_y = n.least.axes[1] - v.y, high_y = n.greatest.axes[1] - v.y;
  const double ax = g.x * low_x, bx = g.x * high_x, ay = g.y * low_y, by = g.y * high_y;
  const double lost = step * (std::abs(ax) + std::abs(bx) + std::abs(ay) + std::abs(by));
  const double least = (ax < bx ? ax : bx) + (ay < by ? ay : by) - lost,
               greatest = (ax < bx ? bx : ax) + (ay < by ? by : ay) + lost;
  if (!star.may_be_beyond_own(least, greatest)) return false;
  const metric_tensor adjugate{n.inverse.m22, -n.inverse.m12, n.inverse.m11};
  return star.is_beyond_own(least, greatest, length_above(g, adjugate, n.spread_squared));
}

inline bool site_tree::is_beyond(const site& w, const star_extent& star) {
  using roundings::step;
  const point& g = star.own();
  const double x = g.x * (w.position.x - star.v().position.x),
               y = g.y * (w.position.y - star.v().position.y);
  const double value = x + y, lost = step * (std::abs(x) + std::abs(y));
  const double least = value - lost, greatest = value + lost;
  return star.may_be_beyond_own(least, greatest) &&
         star.is_beyond_own(least, greatest,
                            length_above(g, w.metric, inverse_determinant_above(w.metric)));
}

}  // namespace asterism::internal::audit_detail
