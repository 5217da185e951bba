// SPDX-License-Identifier: MIT
//
// Proves quickly that a site has no place in a gap of a star, for the many that are far away.
//
// Question: is edge_test(v, w, x, y) certainly false? `excludes` answers yes or "not known".
// On the ray from v in direction u, the first point equidistant from v and z is v + u / s_z(u) with
//   s_z(u) = u.M_z d / C + sqrt(|u|_v^2 - det M_z (u x d)^2 / C) / sqrt(C),  d = z-v, C = |d|_z^2.
// If w is accepted, then in some direction u with u.M_v(w-v) > 0 both s_w(u) > s_x(u) where
// u.M_v(x-v) > 0, and s_w(u) > s_y(u) where u.M_v(y-v) > 0. An upper bound of s_w that is convex in
// u and lower bounds of s_x and s_y that are concave refute that at the two ends of a cone each;
// the cones meet in a direction near that of the gap's Voronoi vertex. Beyond the ray of x or y
// the allowable region of definition 5 is the stronger bound.
// Source: docs/math/certificate.md, sections 4.2 and 4.3, with proofs.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/number.hpp"

namespace asterism::internal::audit_detail {

// Numbers of a neighbour x or y from which the lower bound of s is computed.
struct gap_side {
  gap_side(const site& v, const site& z);

  bounded bound(const vector2<bounded>& u, const bounded& length_squared) const;
  // Returns the reach along the edge d = z - v: the greater of |d|_v / 2 and |d|_v / bound(d),
  // where bound(d) = 1 + |d|_v / |d|_z.
  double reach_along_edge() const;

  vector2<bounded> offset;      // z - v
  vector2<bounded> covector;    // M_z d / C
  vector2<bounded> v_covector;  // M_v d
  bounded v_length_squared;     // |d|_v^2
  bounded inverse_length;       // 1 / sqrt(C)
  double bend = 0;              // at least det M_z / C and det M_v / |d|_v^2
};

class star_gap_filter {
 public:
  // Prepares the filter for the gap from x to y: v, x, y counter-clockwise, all metrics positive
  // definite.
  star_gap_filter(const site& v, const site& x, const site& y);

  // True only if edge_test(v, w, x, y) is certainly false, ties included. Requires w strictly
  // between the rays from v through x and y.
  bool excludes(const site& w) const;
  // Returns R of lemma 4.3, as star_extent uses it: at least 1 / s in the middle direction, the
  // distances to the bisectors of x and y along their edges, and half of both edges.
  double reach() const;

 private:
  site v_;
  gap_side x_, y_;
  // True if the middle direction is certainly within a right angle of x and y, and the lower bounds
  // of s along it are positive.
  bool usable_ = false;
  vector2<bounded> middle_;
  bounded middle_length_squared_;
  bounded middle_bound_x_, middle_bound_y_;
};

}  // namespace asterism::internal::audit_detail
