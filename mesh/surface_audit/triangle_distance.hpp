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

// Returns approximately the nearest point of the triangle, in doubles, and its squared distance.
struct nearest_place {
  triangle_place at;
  double squared_distance = 0;
};
nearest_place nearest_in(const plain_triangle& triangle, const plain_vector& p);

// A triangle with two of its sides and their products, for the distances of many points.
struct measured_triangle {
  plain_vector corner, end, first, second;  // the first side goes from the corner to the end
  double first_squared = 0, both = 0, second_squared = 0;

  explicit measured_triangle(const plain_triangle& t);
};
nearest_place nearest_in(const measured_triangle& triangle, const plain_vector& p);

// Bounds squared distances from one triangle, of every point of an interval or projective point.
// Requires a floating_point_scope(rounding::upward).
class distances_above {
 public:
  explicit distances_above(const plain_triangle& triangle);
  double of(const weighted_point& p) const;
  double of(const interval_vector& p) const;

 private:
  interval_vector nearest_to(const plain_vector& p) const;

  measured_triangle plain_;
  interval_vector corner_, first_, second_;
};
inline double squared_distance_above(const weighted_point& p, const plain_triangle& triangle) {
  return distances_above(triangle).of(p);
}

// True if the point p / w, w > 0, is certainly farther than sqrt(squared) from the triangle.
// Numbers are intervals, which require a floating_point_scope(rounding::upward), or dyadics, for
// which the answer is exact. Divides nothing: all is multiplied by w^2 and the lengths of edges.
template <class Number>
bool is_farther(const space_vector<Number>& p, const Number& w, const plain_triangle& triangle,
                const Number& squared);

extern template bool is_farther(const interval_vector&, const rounded_interval&,
                                const plain_triangle&, const rounded_interval&);
extern template bool is_farther(const exact_vector&, const dyadic&, const plain_triangle&,
                                const dyadic&);

}  // namespace asterism::internal
