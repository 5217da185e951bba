// SPDX-License-Identifier: MIT
//
// Finds the sites near enough to matter to a star, in a tree of boxes.
//
// How near a site w must be depends on its own metric, and on the direction. With g any covector,
// |g|_v and |g|_w its dual lengths in the two metrics (|g|_v^2 = g M_v^-1 g), a site with
//   g . (w - v) > (|g|_v + max(|g|_v, |g|_w)) reach
// is accepted in no gap of the star (docs/math/certificate.md, section 4.3). A box bounds the left
// side from below and the right one from above for all its sites at once; rounding only ever keeps
// a site. The covector is a free choice: two are tried, and before them, as that is cheap, four
// that are the same for all stars: x, y, x + y and x - y. Where the outline of the star's gaps is
// known (audit/star_outline.hpp) it takes the place of the reach.
//
// The mesher has an index with the same descent by a lemma of the same kind (mesh/search/
// site_index). The two are apart deliberately: the auditor must share no code with what it judges.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/star_outline.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal::audit_detail {

class site_tree {
 public:
  // Builds the tree of sites that are finite and positive definite, and that must outlive it.
  explicit site_tree(const std::vector<site>& sites);

  // Returns the numbers of all sites, ordered so that sites near each other are close in the list.
  const std::vector<vertex_index>& order() const { return order_; }
  // Returns the starts of the groups of neighbouring sites in order(), then the number of sites.
  const std::vector<std::size_t>& groups() const { return groups_; }

  // True if the tree keeps bounds by covectors.
  bool has_covectors() const { return !covector_bounds_.empty(); }

  // The centre of a star, and its reach: the distance beyond which no site matters to it. The
  // outline of its gaps says more, if it is known.
  struct reaching {
    site v;
    double reach;
    const star_outline* outline = nullptr;
  };
  // Calls visit(w) for each site that is not certainly too far from v, in an order that depends on
  // the sites alone; v itself may be among them. A visit that returns false ends it. `reach` is R
  // of the lemma, in the metric of v and no less than each gap's; infinite: all sites.
  template <class Visit>
  void visit_near(const reaching& star, const Visit& visit) const {
    centre c = centre_with_covectors(star);
    reaches_along along;
    if (star.outline != nullptr && has_covectors()) c.along = &(along = reaches_of(star, c));
    visit_leaves(c, 0, [&](std::size_t leaf) { return visit_leaf(nodes_[leaf], c, 0, visit); });
  }
  template <class Visit>
  void visit_near(const site& v, double reach, const Visit& visit) const {
    visit_near(reaching{v, reach}, visit);
  }

  // Descends once for several stars: sets `leaves` to nodes that contain all sites which visit_near
  // visits for any of them, except leaves that end before `from` in the order. Returns false, with
  // nothing set, where a common descent costs more: unless all reaches are finite and the stars'
  // metrics much alike.
  bool gather(const std::vector<reaching>& stars, std::vector<std::size_t>& leaves,
              std::size_t from = 0) const;
  // Visits the sites that visit_near would visit without `leaves`, for one of the stars for which
  // the leaves were gathered: those from position `from` of the order on.
  template <class Visit>
  void visit_near(const std::vector<std::size_t>& leaves, const site& v, double reach,
                  const Visit& visit, std::size_t from = 0) const {
    visit_all(leaves, centre_with_covectors({v, reach}), from, visit);
  }

  static constexpr double beyond_all = std::numeric_limits<double>::infinity();
  // One number for each of the covectors x, y, x + y and x - y.
  static constexpr std::size_t covectors = 4;
  using by_covector = std::array<double, covectors>;
  // Reach along a covector g, in one of its two directions: a site w does not matter if g . (w - v)
  // exceeds both of two linear functions of |g|_w, the dual length of g in w's metric.
  struct reach_along {
    double none = beyond_all, rise = 0;  // for the length 0
    double own = 0, at_own = beyond_all, steep = 0;

    double at(double length) const {
      const double less = none + rise * length, more = at_own + (length - own) * steep;
      return less > more ? less : more;
    }
  };
  // Reach along a covector, and reach along its opposite.
  using both_ways = std::array<reach_along, 2>;
  using reaches_along = std::array<both_ways, covectors>;
  // The centre of one star, or of several: their positions are in the box, the metric M of each is
  // at least `metric` / spread_squared and at most spread_squared `metric`. `reach` covers that of
  // every star, each in its own metric, times the root of spread_squared.
  struct centre {
    point low, high;
    metric_tensor metric;
    double reach = 0, spread_squared = 1;
    // Set if the tree is searched by covectors: the value of each at the position of the star, or
    // of the first star; `lost`, a bound of the errors of these values; `length`, an upper bound of
    // the dual length of each in the metric of a single star. `along`, if set, is used in place of
    // the lengths and of the reach: how far the outlines of one or several stars extend along each
    // covector.
    by_covector value{};
    double lost = 0;
    by_covector length{beyond_all, beyond_all, beyond_all, beyond_all};
    const reaches_along* along = nullptr;
    const star_outline* outline = nullptr;  // of a single star, used in place of the reach
  };

  // Sites gathered for several stars whose metrics are much alike.
  struct nearby_sites {
    std::vector<std::size_t> leaves;
    std::vector<std::size_t> nth;  // in the order
    std::vector<double> x, y;      // their places
    // One factor for each site w: w is too far from v, whichever of the stars v is, if |w - v|_v^2
    // times the factor exceeds the square of v's reach.
    std::vector<double> share;
    bool is_in_range = true;       // of what can be measured
    std::vector<double> measured;  // scratch of visit_near
  };
  // Descends once for several stars, and sets `nearby` to the leaves and their sites. Returns false
  // where a common descent costs more: unless all reaches are finite and the stars' metrics much
  // alike, or, in a tree with bounds by covectors, where the leaves are more than `most_leaves`:
  // then to test leaves by outlines before their sites costs less.
  bool gather(const std::vector<reaching>& stars, nearby_sites& nearby,
              std::size_t most_leaves = 40) const;
  // Calls visit(w, squared) for each site that is not certainly too far from v, one of the stars of
  // `nearby`; is_too_far_by compares `squared` with lesser reaches. Returns false, with nothing
  // visited, where numbers are out of range.
  template <class Visit>
  bool visit_near(nearby_sites& nearby, const site& v, double reach, const Visit& visit) const;

  // Leaves gathered for several stars, whatever their metrics.
  struct nearby_leaves {
    std::vector<centre> centres;       // of the stars
    std::vector<reaches_along> along;  // of each, and of all together
    std::vector<std::size_t> leaves;
  };
  // Descends once for several stars by covectors. Returns false, with nothing set, in a tree that
  // keeps no bounds of its sites along the covectors.
  bool gather(const std::vector<reaching>& stars, nearby_leaves& nearby) const;
  // Visits the sites that visit_near would visit for the star with this number among those gathered
  // for.
  template <class Visit>
  void visit_near(const nearby_leaves& nearby, std::size_t star, const Visit& visit) const {
    visit_all(nearby.leaves, nearby.centres[star], 0, visit);
  }
  // True if the site for which visit_near gave this `squared` is certainly too far from the same v
  // for this reach.
  static bool is_too_far_by(double squared, double reach) {
    constexpr double up = 1 + 0x1p-48, least = 0x1p-400;
    const double square = reach * reach;
    return squared > (square > least ? square : least) * up;
  }

  // True if w is certainly too far from v to matter to a gap with this reach.
  static bool is_too_far(const site& v, double reach, const site& w);

 private:
  static constexpr std::size_t leaf_size = 8;
  static constexpr std::size_t most_depth = 64;  // nodes are halved
  // Largest number of sites for which the tree keeps bounds by covectors: 60 bytes a site, worth
  // while where metrics vary much from site to site, which those of a large mesh do not.
  static constexpr std::size_t most_with_covectors = 100'000;
  // The sites order_[first .. last), in a box. Every metric M_w among them is at least
  // inverse^-1 / spread_squared, as quadratic forms.
  struct node {
    point low, high;
    metric_tensor inverse;
    double spread_squared = 0;  // infinite where not known
    std::size_t first = 0, last = 0;
    std::size_t right = 0;  // the left child follows its parent; no right child: a leaf
  };
  // Bounds of all sites of a node along the four covectors.
  struct covector_bounds {
    by_covector least, greatest, length;  // at most, at least and at least that of each site
  };
  // Bound of the inverse metrics of a node's sites: all M_w^-1 are at most `factor` times this
  // tensor.
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

  // Returns the number of nodes of a tree with this number of sites, at least one.
  static std::size_t node_count(std::size_t sites);
  void build(std::size_t self, std::size_t first, std::size_t last);
  void bound_leaf(node& n) const;
  void bound_parent(node& n, const node& left, const node& right) const;
  void bound_covectors();
  // Returns the bounds by covectors of a node whose children's bounds are known.
  covector_bounds bounds_of(std::size_t self) const;
  static by_covector lengths_of(const metric_tensor& m, double inverse_determinant);
  static centre centre_of(const site& v, double reach);
  static centre centre_with_covectors(const reaching& star);
  // Returns the reach along a covector and its opposite, from the greatest values at the points of
  // the outline. `own` is the covector's dual length in the metric of v, or any other.
  static both_ways reach_in(const star_outline& outline, std::size_t covector, double own);
  // Returns the reaches of a single star.
  static reaches_along reaches_of(const reaching& star, const centre& one);
  // True if some covector certainly separates all sites of node `self`, or one at d, from v: either
  // one of the four covectors, or the one that separation_along chooses for the node.
  bool are_beyond(std::size_t self, const centre& v) const;
  static bool is_beyond(const point& d, const by_covector& length, const centre& v);
  static bool is_beyond_along(const point& d, const by_covector& length,
                              const reaches_along& along);
  // Returns the value of g . (w - v) beyond which a site w is too far, if the dual length of g in
  // w's metric is at most `length`.
  static double bound_along(const centre& v, std::size_t covector, double length) {
    constexpr double roundings = 1 + 0x1p-47, underflow = 0x1p-900;
    const double own = v.length[covector];
    return v.reach * (own + (own > length ? own : length)) * roundings + underflow;
  }
  // True if every site w with g . (w - v) from `least` to `greatest`, and with a dual length of g
  // of at most `length`, is too far along g. No reach along a covector is negative.
  static bool is_beyond_along(const both_ways& along, double least, double greatest,
                              double length) {
    constexpr double roundings = 1 + 0x1p-47, underflow = 0x1p-900;
    const bool is_back = greatest < 0;
    const double beyond = is_back ? -greatest : least;
    return beyond > 0 && beyond > along[is_back].at(length) * roundings + underflow;
  }
  static std::optional<centre> centre_of(const std::vector<reaching>& stars);
  // Returns the greatest reach along each covector of several stars.
  static reaches_along joined(const nearby_leaves& stars);
  static separation separation_along(const point& h, const offset_box& to, const centre& v,
                                     const inverse_bound& inverse);
  static bool too_far(const offset_box& to, const centre& v, const inverse_bound& inverse);
  static bool too_far_from_both(const point& c, const offset_box& to, const centre& v,
                                const inverse_bound& inverse);
  static bool too_far(const node& n, const centre& v);
  static bool is_outside(const node& n, const offset_box& to, const star_outline& outline);
  static bool too_far(const site& w, const centre& v);
  // Returns the factor of |w - v|_v^2 that holds for all sites w of the node and stars v; 0 where
  // none is known.
  static double share_of(const node& n, const centre& stars);
  // Lists the sites of the leaves in `nearby`.
  void list_sites(const centre& stars, nearby_sites& nearby) const;
  // True if measure() is valid for v, and its results may be compared with the square of the reach.
  static bool is_measurable(const site& v, double reach);
  // Sets `measured` to lower bounds, one for each nearby site: |w - v|_v^2 times the site's factor.
  static void measure(nearby_sites& nearby, const site& v);
  // True if a site with metric m at displacement d is too far; takes an upper bound of 1 / det m.
  static bool too_far(const point& d, const metric_tensor& m, double inverse_determinant,
                      const centre& v);
  // Returns the square of a distance from v beyond which no site of the node matters in any
  // direction; infinite where none is known. Nearer sites need not matter.
  static double far_squared(const node& n, const centre& v);
  // True if the squared length of d in the metric m certainly exceeds `far_squared`.
  static bool is_farther(const point& d, const metric_tensor& m, double far_squared);
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
  void visit_all(const std::vector<std::size_t>& leaves, const centre& c, std::size_t from,
                 const Visit& visit) const;
  template <class Visit>
  bool visit_leaf(const node& n, const centre& v, std::size_t from, const Visit& visit) const;
  // Calls visit(leaf) for each leaf that is not too far and does not end before `from` in the
  // order.
  template <class Visit>
  void visit_leaves(const centre& c, std::size_t from, const Visit& visit) const;

  const std::vector<site>& sites_;
  std::vector<vertex_index> order_;
  std::vector<std::size_t> groups_;
  std::vector<point> places_;                 // in that order
  std::vector<double> inverse_determinants_;  // upper bounds, in that order
  // Bounds by covectors, for each site in the order of the tree and for each node; empty in large
  // trees.
  std::vector<by_covector> lengths_;
  std::vector<covector_bounds> covector_bounds_;
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
    if (n.last <= from || are_beyond(self, c) || too_far(n, c)) continue;
    if (n.right == 0) {
      if (!goes_on(visit, self)) return;
      continue;
    }
    open[waiting++] = n.right;
    open[waiting++] = self + 1;
  }
}

template <class Visit>
bool site_tree::visit_leaf(const node& n, const centre& v, std::size_t from,
                           const Visit& visit) const {
  const double far = v.outline == nullptr ? far_squared(n, v) : 0;
  for (std::size_t i = n.first < from ? from : n.first; i < n.last; ++i) {
    const point d{places_[i].x - v.low.x, places_[i].y - v.low.y};
    if (!lengths_.empty() && is_beyond(d, lengths_[i], v)) continue;
    if (v.outline == nullptr && is_farther(d, v.metric, far)) continue;
    if (v.outline != nullptr) {
      if (!goes_on(visit, order_[i])) return false;
      continue;
    }
    if (!too_far(d, sites_[order_[i]].metric, inverse_determinants_[i], v) &&
        !goes_on(visit, order_[i]))
      return false;
  }
  return true;
}

template <class Visit>
void site_tree::visit_all(const std::vector<std::size_t>& leaves, const centre& c, std::size_t from,
                          const Visit& visit) const {
  for (const std::size_t leaf : leaves)
    if (nodes_[leaf].last > from && !are_beyond(leaf, c) && !too_far(nodes_[leaf], c) &&
        !visit_leaf(nodes_[leaf], c, from, visit))
      return;
}

// Falls back to the exact bound of a site where the leaf's bound is weak.
template <class Visit>
bool site_tree::visit_near(nearby_sites& nearby, const site& v, double reach,
                           const Visit& visit) const {
  constexpr double weak = 0.15;  // of a share, which is at most a quarter
  if (!(nearby.is_in_range && is_measurable(v, reach))) return false;
  measure(nearby, v);
  const double* const measured = nearby.measured.data();
  for (std::size_t k = 0, all = nearby.nth.size(); k < all; ++k) {
    if (is_too_far_by(measured[k], reach)) continue;
    const std::size_t i = nearby.nth[k];
    const point d{places_[i].x - v.position.x, places_[i].y - v.position.y};
    if (nearby.share[k] < weak &&
        too_far(d, sites_[order_[i]].metric, inverse_determinants_[i], centre_of(v, reach)))
      continue;
    visit(order_[i], measured[k]);
  }
  return true;
}

inline bool site_tree::is_beyond(const point& d, const by_covector& length, const centre& v) {
  if (v.along != nullptr) return is_beyond_along(d, length, *v.along);
  constexpr double step = 0x1p-48;
  const double x = std::abs(d.x), y = std::abs(d.y), lost = step * (x + y);
  return x - lost > bound_along(v, 0, length[0]) || y - lost > bound_along(v, 1, length[1]) ||
         std::abs(d.x + d.y) - lost > bound_along(v, 2, length[2]) ||
         std::abs(d.x - d.y) - lost > bound_along(v, 3, length[3]);
}

inline bool site_tree::is_beyond_along(const point& d, const by_covector& length,
                                       const reaches_along& along) {
  constexpr double step = 0x1p-48;
  const double lost = step * (std::abs(d.x) + std::abs(d.y));
  const auto is_beyond = [&](std::size_t k, double value) {
    return is_beyond_along(along[k], value - lost, value + lost, length[k]);
  };
  return is_beyond(0, d.x) || is_beyond(1, d.y) || is_beyond(2, d.x + d.y) ||
         is_beyond(3, d.x - d.y);
}

inline bool site_tree::are_beyond(std::size_t self, const centre& v) const {
  if (!has_covectors() || !(v.along != nullptr || v.length.front() < beyond_all)) return false;
  const covector_bounds& all = covector_bounds_[self];
  for (std::size_t k = 0; k < covectors; ++k) {
    const double least = all.least[k] - v.value[k] - v.lost,
                 greatest = all.greatest[k] - v.value[k] + v.lost, length = all.length[k];
    if (v.along != nullptr) {
      if (is_beyond_along((*v.along)[k], least, greatest, length)) return true;
      continue;
    }
    const double bound = bound_along(v, k, length);
    if (least > bound || -greatest > bound) return true;
  }
  return false;
}

}  // namespace asterism::internal::audit_detail
