// SPDX-License-Identifier: MIT
//
// Constructs points where new sites may go, in doubles: Voronoi vertices of three sites, the places
// where a Voronoi arc leaves its wedge, and the points where a boundary subsegment is split.
//
// A constructed point is rounded once, and every test is made on the rounded point. A point that
// is missed or imprecise only loses a better candidate, and never makes a mesh wrong.
// Coordinates far outside the range of squares (about 1e+-100) are scaled away before anything
// is multiplied.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"

namespace asterism::internal {

// Returns u^T M w.
inline double inner_product(const metric_tensor& m, const point& u, const point& w) {
  return m.m11 * (u.x * w.x) + m.m12 * (u.x * w.y + u.y * w.x) + m.m22 * (u.y * w.y);
}

// Returns u^T M u to about 1e-11, however thin the metric is (numerics/ill_conditioned_metric.hpp).
inline double squared_length(const metric_tensor& m, const point& u) {
  const double first = m.m11 * (u.x * u.x), last = m.m22 * (u.y * u.y);
  const double plain = first + m.m12 * (u.x * u.y + u.y * u.x) + last;
  constexpr double part = 0x1p-14;  // what is left when as much cancels as in is_thin
  const double magnitude = first + last;
  if (plain > part * magnitude || !(magnitude < 0x1p960)) return plain;
  return squared_length_of_thin(m, u.x, u.y);
}

// Returns f_s(q), the squared distance from s to q as s measures it.
inline double squared_distance(const site& s, const point& q) {
  return squared_length(s.metric, {q.x - s.position.x, q.y - s.position.y});
}

// Returns the real points with f_a = f_b = f_c, at most four, each once, nearest (as measured by
// the three) first. Points at infinity are left out; of infinitely many (three sites with one
// isotropic bisector) some may be returned. Does not depend on the order of a, b and c. Method:
// on the lines through one of the three sites, both bisectors are quadratics in the reciprocal
// distance from that site; the resultant of the two quadratics is a quartic in the direction.
std::vector<point> voronoi_vertices(const site& a, const site& b, const site& c);

// Returns the ends of the arc of v and w inside wedge(v, w): points of the bisector on the wedge's
// border, at most two. An arc that runs to infinity inside the wedge has no end there.
std::vector<point> wedge_exits(const site& v, const site& w);

// Returns the point where the segment a b meets the bisector of a and b, rounded: the point equally
// far from both.
point bisector_point(const site& a, const site& b);

// Returns the point of segment a b at the given distance from a, as a measures it, rounded.
point point_at_distance(const site& a, const point& b, double distance);

}  // namespace asterism::internal
