// SPDX-License-Identifier: MIT
//
// Bounds distances between points and triangles in space. A triangle may be flat or a point: it is
// the hull of its corners.
#pragma once

#include <array>

#include "asterism/mesh/surface_audit/space_algebra.hpp"

namespace asterism::internal {

using plain_triangle = std::array<space_point, 3>;

// A point (1 - s - t) a + s b + t c of a triangle: s, t >= 0 and s + t <= 1, exactly.
struct triangle_place {
  double s = 0, t = 0;
};

// Returns about the nearest point of the triangle, in doubles, and its squared distance.
struct nearest_place {
  triangle_place at;
  double squared_distance = 0;
};
nearest_place nearest_in(const plain_triangle& triangle, const plain_vector& p);

// Returns an upper bound of the squared distance of every point of an interval, or projective
// point, from the triangle. In a floating_point_scope(rounding::upward).
double squared_distance_above(const weighted_point& p, const plain_triangle& triangle);

// True if the point p / w, w > 0, is certainly farther than sqrt(squared) from the triangle.
// Numbers are intervals, in an upward scope, or dyadics, for which the answer is exact.
// Divides nothing: all is multiplied by w^2 and the lengths of edges.
template <class Number>
bool is_farther(const space_vector<Number>& p, const Number& w, const plain_triangle& triangle,
                const Number& squared);

extern template bool is_farther(const interval_vector&, const rounded_interval&,
                                const plain_triangle&, const rounded_interval&);
extern template bool is_farther(const exact_vector&, const dyadic&, const plain_triangle&,
                                const dyadic&);

}  // namespace asterism::internal
