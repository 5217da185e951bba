// SPDX-License-Identifier: MIT
//
// Finds the sites near a place, with a quadtree that grows with the mesh.
//
// Every node knows the tight box of its sites and ranges of their inverse tensors. This answers two
// kinds of query: all sites in a box (exact), and all sites that are not certainly out of a star's
// reach (conservative, for metrics that differ from site to site). Let |w|_v be the length of w - v
// in v's metric, sigma^2 the largest eigenvalue of M_w^-1 M_v, or 1 if that is more, and R the
// greatest reach of the star's gaps (about the distance to the Voronoi vertex or half an edge). A
// site with |w|_v > (1 + sigma) R is accepted in no gap. Source: docs/math/certificate.md, section
// 4.3.
//
// Deterministic: sites are visited in an order that depends on the insertions alone.
//
// The auditor has a tree of its own with the same descent by the same lemma (mesh/audit/site_tree),
// deliberately: it must share no code with what it judges.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <boost/container/deque.hpp>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

class site_index {
 public:
  // Queries that an index must answer: positions alone (visit_box, visit_clusters, spacing_near),
  // or all, which takes bounds of the sites' metrics.
  enum class purpose { places, everything };

  site_index() = default;
  // Makes an empty index of sites in, or not far outside, the box.
  explicit site_index(const bounding_box& box, purpose asked_for = purpose::everything);

  std::size_t size() const { return size_; }
  // Adds sites[w]. Requires a finite position and a positive definite metric; each index once.
  void insert(const std::vector<site>& sites, vertex_index w);
  // Follows a renumbering: the former sites[w] is now sites[to[w]].
  void renumber(const std::vector<vertex_index>& to);

  // Calls visit(w) for each site in the closed box, until visit returns false. Returns whether it
  // never did.
  template <class Visit>
  bool visit_box(const std::vector<site>& sites, const point& low, const point& high,
                 Visit&& visit) const;
  // Calls visit(places, which) for a few sites at a time, with their positions and their numbers:
  // for all sites in the closed box, and for some others near it. Requires an index for places
  // alone.
  template <class Visit>
  bool visit_clusters(const std::vector<site>& sites, const bounding_box& box, Visit&& visit) const;
  // Calls visit(w) for each site w that may see a point q of the box within the distance:
  // |q - w|_w <= distance.
  template <class Visit>
  bool visit_seeing(const bounding_box& box, double distance, Visit&& visit) const;
  template <class Visit>
  bool visit_seeing(const point& q, double distance, Visit&& visit) const {
    return visit_seeing(bounding_box{q, q}, distance, visit);
  }

  // Calls visit(v, w) once for each two sites that may be within the distance of each other as
  // either measures it. The distance is read again before each test, and may shrink meanwhile.
  template <class Visit>
  void visit_pairs(const double& distance, Visit&& visit) const {
    if (!nodes_.empty()) visit_pairs(nodes_[0], nodes_[0], distance, visit);
  }
  // Calls visit(box, extent, each) for groups of a few sites near each other: the box around them,
  // the half extents of a box around all points that any of them may see within distance 1, and a
  // function that calls its argument for each of them.
  template <class Visit>
  void visit_groups(Visit&& visit) const;

  // Returns the approximate distance between sites near v, as v measures; 0 where there are too few
  // sites.
  double spacing_near(const site& v) const;

  // Calls visit(w) for each site not certainly out of reach of v, with R = reach in v's metric,
  // infinite where no bound is known; v itself may be among them.
  template <class Visit>
  bool visit_reach(const std::vector<site>& sites, const site& v, double reach,
                   Visit&& visit) const;
  // Calls visit(w) for each site that is neither certainly out of reach, as in visit_reach, nor
  // certainly outside the closed cone at v from the ray through y counter-clockwise to the ray
  // through x. Requires that the cone is less than half a turn.
  template <class Visit>
  bool visit_cone(const std::vector<site>& sites, const site& v, double reach, const point& y,
                  const point& x, Visit&& visit) const;

 private:
  static constexpr int leaf_capacity = 8;
  static constexpr int most_levels = 60;  // deeper, distinct doubles of one box need not separate
  static constexpr std::uint32_t none = 0;

  // Bounds of the inverses of a node's tensors.
  struct inverse_range {
    double m11 = 0, m22 = 0, determinant = 0;  // above, above, below
    double m12_low = 0, m12_high = 0;
  };
  // Part of a node that every descent reads; the rest is kept in a separate list.
  struct node {
    bounding_box box;  // tight around the sites below
    std::uint32_t first_child = none;
    std::uint32_t count = 0;    // of the sites below
    std::uint32_t leaf = none;  // in leaves_; of nodes without children that have sites
  };
  // Sites of a node without children: the first few in place, the rest in an overflow list.
  struct leaf_sites {
    std::array<vertex_index, leaf_capacity> first;
    std::uint32_t overflow = none;  // the rest, in overflow_; only on the last level
  };

  template <class Visit>
  bool visit_leaf_inside(const std::vector<site>& sites, const node& n, const bounding_box& box,
                         Visit& visit) const;
  template <class Visit>
  bool visit_cluster(const std::vector<site>& sites, const node& n, Visit&& visit) const;
  // Returns 1 if the closed boxes meet, or the point is in the box; else 0.
  static std::uint32_t touches(const bounding_box& a, const bounding_box& b) {
    return std::uint32_t{a.low.x <= b.high.x} & std::uint32_t{a.high.x >= b.low.x} &
           std::uint32_t{a.low.y <= b.high.y} & std::uint32_t{a.high.y >= b.low.y};
  }
  static std::uint32_t holds(const bounding_box& box, const point& q) {
    return touches({q, q}, box);
  }
  const inverse_range& inverse_of(const node& n) const {
    return inverses_[static_cast<std::size_t>(&n - nodes_.data())];
  }
  // A star's centre with numbers prepared for measuring distances to nodes and sites.
  struct centre {
    const site* v;
    double determinant_below;  // of its metric; 0 when not known
    double reach;
  };
  static centre centre_of(const site& v, double reach);
  // Bound of distances: every |w - v|_v^2 of the node is at least squared_least / square_above, if
  // that is positive.
  struct approach {
    double squared_least = 0, square_above = 0;
    bool is_beyond(double squared_limit) const;
  };
  static approach approach_of(const node& n, const centre& c);
  double half_trace_above(const node& n, const centre& c) const;
  double limit(const node& n, const centre& c) const;
  double rough_squared_limit(const node& n, const centre& c) const;
  bool out_of_reach(const node& n, const centre& c) const;
  static bool is_beyond(const point& q, const centre& c, double limit);
  // Rectangle of the plane that a node divides. Computed on the way down, not stored: the nodes of
  // a large mesh take much of its memory.
  struct cell {
    point middle, half;
    // Returns the number of the quarter that contains q.
    std::uint32_t quadrant(const point& q) const {
      return (q.x >= middle.x ? 1U : 0U) + (q.y >= middle.y ? 2U : 0U);
    }
    cell quarter(std::uint32_t number) const {
      const point half_of_it{half.x / 2, half.y / 2};
      return {{middle.x + ((number & 1U) != 0 ? half_of_it.x : -half_of_it.x),
               middle.y + ((number & 2U) != 0 ? half_of_it.y : -half_of_it.y)},
              half_of_it};
    }
  };
  std::uint32_t smallest_around(const bounding_box& box) const;
  static bool is_right_of(const bounding_box& box, const point& from, const point& to);
  static inverse_range inverse_range_of(const metric_tensor& m);
  void cover(std::uint32_t at, const point& q, const inverse_range& inverse);
  inverse_range inverse_for(const site& s) const;
  void put_in_leaf(std::uint32_t at, const point& q, vertex_index w);
  void split(const std::vector<site>& sites, std::uint32_t at, const cell& whole);
  template <class Visit>
  bool visit_leaf(const node& n, Visit&& visit) const;
  template <class Visit>
  void visit_pairs(const node& a, const node& b, const double& distance, Visit& visit) const;
  bool farther_apart(const node& a, const node& b, double distance) const;
  template <class Outside, class Visit>
  bool visit_reach_within(const std::vector<site>& sites, const site& v, double reach,
                          const Outside& is_outside, Visit&& visit) const;

  std::vector<node> nodes_;              // the root first; no node but the root has index 0
  std::vector<inverse_range> inverses_;  // of the nodes; none where places alone are asked for
  bool bounds_metrics_ = true;
  std::vector<leaf_sites> leaves_{1};
  // Positions of the first sites of leaves, for an index of positions alone: queries then read only
  // these, while sites may be anywhere in memory. Kept in pages: a growing vector would hold them
  // twice.
  using place_blocks = boost::container::deque_options_t<boost::container::block_size<256>>;
  boost::container::deque<std::array<point, leaf_capacity>, void, place_blocks> places_;
  std::vector<std::vector<vertex_index>> overflow_{1};
  cell root_;
  std::size_t size_ = 0;
};

template <class Visit>
bool site_index::visit_leaf(const node& n, Visit&& visit) const {
  if (n.count == 0) return true;
  const leaf_sites& here = leaves_[n.leaf];
  const std::uint32_t at_hand = n.count < leaf_capacity ? n.count : leaf_capacity;
  for (std::uint32_t i = 0; i < at_hand; ++i)
    if (!visit(here.first[i])) return false;
  if (here.overflow != none)
    for (const vertex_index w : overflow_[here.overflow])
      if (!visit(w)) return false;
  return true;
}

// Returns the smallest node whose cell holds the box. Requires that there are nodes.
inline std::uint32_t site_index::smallest_around(const bounding_box& box) const {
  std::uint32_t at = 0;
  for (cell here = root_; nodes_[at].first_child != none;) {
    const std::uint32_t quadrant = here.quadrant(box.low);
    if (quadrant != here.quadrant(box.high)) break;
    at = nodes_[at].first_child + quadrant;
    here = here.quarter(quadrant);
  }
  return at;
}

template <class Visit>
bool site_index::visit_box(const std::vector<site>& sites, const point& low, const point& high,
                           Visit&& visit) const {
  const bounding_box box{low, high};
  // Size of the stack of a descent: each level leaves at most three children waiting.
  std::array<std::uint32_t, 3 * most_levels + 4> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = smallest_around(box);
  while (waiting > 0) {
    const node& n = nodes_[open[--waiting]];
    for (std::uint32_t i = 0; n.first_child != none && i < 4; ++i) {
      open[waiting] = n.first_child + i;
      waiting += touches(nodes_[n.first_child + i].box, box);
    }
    if (n.first_child == none && n.count > 0 && !visit_leaf_inside(sites, n, box, visit))
      return false;
  }
  return true;
}

// Compares all sites of a leaf with the box first, then visits those inside: mispredicted branches
// would cost more than all comparisons.
template <class Visit>
bool site_index::visit_leaf_inside(const std::vector<site>& sites, const node& n,
                                   const bounding_box& box, Visit& visit) const {
  const leaf_sites& here = leaves_[n.leaf];
  const std::uint32_t at_hand = n.count < leaf_capacity ? n.count : leaf_capacity;
  std::uint32_t inside = 0;
  const point* const places = bounds_metrics_ ? nullptr : places_[n.leaf].data();
  for (std::uint32_t i = 0; i < at_hand; ++i)
    inside |= holds(box, places != nullptr ? places[i] : sites[here.first[i]].position) << i;
  for (; inside != 0; inside &= inside - 1)
    if (!visit(here.first[static_cast<std::size_t>(std::countr_zero(inside))])) return false;
  if (here.overflow != none)
    for (const vertex_index w : overflow_[here.overflow])
      if (holds(box, sites[w].position) != 0 && !visit(w)) return false;
  return true;
}

// Writes each node to both lists, of parents and of leaves, and advances at most the one that it
// belongs to: a branch would be mispredicted every other time.
template <class Visit>
bool site_index::visit_clusters(const std::vector<site>& sites, const bounding_box& box,
                                Visit&& visit) const {
  constexpr std::size_t most_found = 32;
  std::array<std::uint32_t, 3 * most_levels + 4> open;
  std::array<std::uint32_t, most_found> found;
  std::size_t waiting = 0, leaves = 0;
  const auto put = [&](std::uint32_t at) {
    const node& n = nodes_[at];
    const std::uint32_t is_touched = touches(n.box, box), is_parent{n.first_child != none};
    open[waiting] = found[leaves] = at;
    waiting += is_touched & is_parent;
    leaves += is_touched & (1 - is_parent);
  };
  if (!nodes_.empty()) put(smallest_around(box));
  while (waiting > 0 || leaves > 0) {
    while (waiting > 0 && leaves + 4 < most_found) {
      const std::uint32_t first = nodes_[open[--waiting]].first_child;
      for (std::uint32_t i = 0; i < 4; ++i) put(first + i);
    }
    for (; leaves > 0; --leaves)
      if (!visit_cluster(sites, nodes_[found[leaves - 1]], visit)) return false;
  }
  return true;
}

template <class Visit>
bool site_index::visit_cluster(const std::vector<site>& sites, const node& n, Visit&& visit) const {
  const leaf_sites& here = leaves_[n.leaf];
  const std::size_t at_hand = n.count < leaf_capacity ? n.count : leaf_capacity;
  if (!visit(std::span(places_[n.leaf]).first(at_hand), std::span(here.first).first(at_hand)))
    return false;
  if (here.overflow != none)
    for (const vertex_index w : overflow_[here.overflow])
      if (!visit(std::span(&sites[w].position, 1), std::span(&w, 1))) return false;
  return true;
}

// Uses that |dx| <= distance sqrt(M^-1_11) wherever |d|_M <= distance; the margin covers the
// roundings.
template <class Visit>
bool site_index::visit_seeing(const bounding_box& box, double distance, Visit&& visit) const {
  const auto beyond = [](double from, double to, double low, double high) {
    return to < low ? low - to : from > high ? from - high : 0;
  };
  std::array<std::uint32_t, 3 * most_levels + 4> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const node& n = nodes_[open[--waiting]];
    const double reach = distance * (1 + 0x1p-40);
    if (n.count == 0 ||
        beyond(box.low.x, box.high.x, n.box.low.x, n.box.high.x) >
            reach * std::sqrt(inverse_of(n).m11) ||
        beyond(box.low.y, box.high.y, n.box.low.y, n.box.high.y) >
            reach * std::sqrt(inverse_of(n).m22))
      continue;
    if (n.first_child != none)
      for (std::uint32_t i = 0; i < 4; ++i) open[waiting++] = n.first_child + i;
    else if (!visit_leaf(n, visit))
      return false;
  }
  return true;
}

// Two boxes are apart by the gap between them in either direction; the margin covers the roundings.
inline bool site_index::farther_apart(const node& a, const node& b, double distance) const {
  const inverse_range &of_a = inverse_of(a), &of_b = inverse_of(b);
  const auto gap = [](double low_a, double high_a, double low_b, double high_b) {
    return std::max({low_b - high_a, low_a - high_b, 0.0});
  };
  const double x = gap(a.box.low.x, a.box.high.x, b.box.low.x, b.box.high.x),
               y = gap(a.box.low.y, a.box.high.y, b.box.low.y, b.box.high.y);
  const double squared = distance * distance * (1 + 0x1p-40);
  return x * x > squared * std::max(of_a.m11, of_b.m11) ||
         y * y > squared * std::max(of_a.m22, of_b.m22);
}

template <class Visit>
void site_index::visit_pairs(const node& a, const node& b, const double& distance,
                             Visit& visit) const {
  if (a.count == 0 || b.count == 0 || farther_apart(a, b, distance)) return;
  const auto child = [this](const node& n, std::uint32_t i) -> const node& {
    return nodes_[n.first_child + i];
  };
  if (&a == &b && a.first_child != none) {
    for (std::uint32_t i = 0; i < 4; ++i)
      for (std::uint32_t j = 0; j <= i; ++j) visit_pairs(child(a, i), child(a, j), distance, visit);
  } else if (a.first_child != none && (b.first_child == none || a.count >= b.count)) {
    for (std::uint32_t i = 0; i < 4; ++i) visit_pairs(child(a, i), b, distance, visit);
  } else if (b.first_child != none) {
    for (std::uint32_t i = 0; i < 4; ++i) visit_pairs(a, child(b, i), distance, visit);
  } else {
    visit_leaf(a, [&](vertex_index v) {
      return visit_leaf(b,
                        [&](vertex_index w) {
                          if (&a == &b && w == v)
                            return false;  // those that follow come with it in turn
                          visit(v, w);
                          return true;
                        }) ||
             true;
    });
  }
}

template <class Visit>
void site_index::visit_groups(Visit&& visit) const {
  for (const node& n : nodes_)
    if (n.first_child == none && n.count > 0)
      visit(n.box, point{std::sqrt(inverse_of(n).m11), std::sqrt(inverse_of(n).m22)},
            [&](const auto& take) {
              visit_leaf(n, [&](vertex_index w) {
                take(w);
                return true;
              });
            });
}

template <class Visit>
bool site_index::visit_reach(const std::vector<site>& sites, const site& v, double reach,
                             Visit&& visit) const {
  const auto nothing_else = [](const bounding_box&) { return false; };
  return visit_reach_within(sites, v, reach, nothing_else, visit);
}

template <class Visit>
bool site_index::visit_cone(const std::vector<site>& sites, const site& v, double reach,
                            const point& y, const point& x, Visit&& visit) const {
  const auto is_outside = [&](const bounding_box& box) {
    return is_right_of(box, v.position, y) || is_right_of(box, x, v.position);
  };
  const auto visit_inside = [&](vertex_index w) {
    const point& q = sites[w].position;
    return is_outside({q, q}) || visit(w);
  };
  return visit_reach_within(sites, v, reach, is_outside, visit_inside);
}

// Calls visit(w) as visit_reach() does, but skips nodes for which is_outside(box) is true.
template <class Outside, class Visit>
bool site_index::visit_reach_within(const std::vector<site>& sites, const site& v, double reach,
                                    const Outside& is_outside, Visit&& visit) const {
  const centre c = centre_of(v, reach);
  std::array<std::uint32_t, 3 * most_levels + 4> open;
  std::size_t waiting = 0;
  if (!nodes_.empty()) open[waiting++] = 0;
  while (waiting > 0) {
    const node& n = nodes_[open[--waiting]];
    if (n.count == 0 || out_of_reach(n, c) || is_outside(n.box)) continue;
    if (n.first_child != none) {
      for (std::uint32_t i = 0; i < 4; ++i) open[waiting++] = n.first_child + i;
      continue;
    }
    const double most = limit(n, c);
    const bool on = visit_leaf(
        n, [&](vertex_index w) { return is_beyond(sites[w].position, c, most) || visit(w); });
    if (!on) return false;
  }
  return true;
}

}  // namespace asterism::internal
