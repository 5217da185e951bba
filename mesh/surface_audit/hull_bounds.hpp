// SPDX-License-Identifier: MIT
//
// Bounds distances by control points. All functions require a
// floating_point_scope(rounding::upward).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/mesh/surface_audit/triangle_distance.hpp"
#include "asterism/mesh/surface_audit/triangle_net.hpp"

namespace asterism::internal {

using interval_triangle = std::array<interval_vector, 3>;

// Returns a bound of |r(x) - p(x)|^2 over a triangle: r is the net, p the flat triangle with these
// corners. The difference of a quotient R / w is (w p - R) / w, of one degree more, whose value is
// in the hull of its coefficients' quotients, since those of w are positive.
double squared_gap_above(const triangle_net& net, bool is_rational,
                         const interval_triangle& corners);

// Returns the control points themselves, divided by their weights.
std::vector<interval_vector> euclidean(const weighted_point* points, std::size_t count,
                                       bool is_rational);

// Returns a bound of the squared distance of the points' hull from one triangle, and the farthest
// point. The distance from a convex set is a convex function.
struct hull_distance {
  double squared = 0;
  std::size_t farthest = 0;
};
hull_distance hull_distance_above(const std::vector<interval_vector>& points,
                                  const plain_triangle& triangle);

// Returns a bound of the squared distance of the hull from the union of two triangles with a common
// edge. A plane through the edge parts the hull in two; each part is the hull of its points and of
// the crossings of segments between points on different sides, and is compared with one triangle.
// `common` are the edge's ends, the third corners `first` and `second`.
struct two_triangles {
  std::array<space_point, 2> common;
  space_point first, second;
};
double hull_distance_above(const std::vector<interval_vector>& points, const two_triangles& two);

}  // namespace asterism::internal
