// SPDX-License-Identifier: MIT
//
// Decides whether a triangle is good enough: its size, and its angles as each of its three vertices
// measures them.
#pragma once

#include <array>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Set of a triangle's nine angles: which[i][j] is the one at corner i as corner j measures it.
struct angle_set {
  std::array<std::array<bool, 3>, 3> which{};
};

// The angle bound, prepared for many tests.
class angle_requirement {
 public:
  // Makes the requirement; 0 <= degrees < 60.
  explicit angle_requirement(double degrees);

  double degrees() const { return degrees_; }
  // True if an angle of the triangle is below the bound from the perspective of any of its
  // vertices, that is if a^T M b <= cot(bound) sqrt(det M) (a x b) fails for two edges a, b at a
  // corner and some M. Errors can only say "low": the doubles carry error terms and the bound a
  // guard of 1e-9 relative, so that a triangle called good meets the bound exactly. Never low when
  // the bound is zero. Requires a counter-clockwise triangle.
  bool is_low(const triangle_sites& t) const { return is_low(t, {}); }
  // True if an angle outside of the set given is low.
  bool is_low(const triangle_sites& t, const angle_set& left_out) const;

 private:
  double degrees_;
  double cotangent_;
};

// Returns the triangle in coordinates in which its first thin metric is round
// (numerics/ill_conditioned_metric.hpp), or as it is if none is thin. Angles and lengths stay the
// same up to rounding, and doubles can then measure them.
triangle_sites in_round_coordinates(triangle_sites t);

// Returns the smallest of the nine angles, in degrees, in doubles, to rank triangles. For
// coordinates whose products are in range, as in the unit frame; numerics/metric_angle.hpp has a
// function for coordinates of any magnitude.
double smallest_angle(const triangle_sites& t);

// An angle in degrees, used as a threshold, and its cotangent.
struct angle_threshold {
  explicit angle_threshold(double degrees);

  double degrees, cotangent;
};

// Returns for each threshold whether smallest_angle() is below it, at a part of the cost. Requires
// coordinates in which the metrics are round.
std::array<bool, 2> smallest_angle_is_below(const triangle_sites& t,
                                            const std::array<angle_threshold, 2>& thresholds);

// Returns the angle at `corner` swept counter-clockwise from `first` to `last` as the corner
// measures it, in degrees, below 180. Requires orientation(corner, first, last) > 0.
double corner_angle(const site& corner, const point& first, const point& last);

// Target of size control, in metric length: the distance from the sites of a triangle to their
// nearest common Voronoi vertex. Insertions at vertices farther than this leave edges between it
// and twice it, around metric length 1.
inline constexpr double largest_circumradius = 0.75;
// Greatest metric length of a boundary subsegment: longer ones are split, so that sites at
// largest_circumradius from other sites do not encroach on them.
inline constexpr double longest_subsegment = 1.2;
// Greatest metric length of a boundary subsegment where a domain is filled at once: 1.2 times
// largest_circumradius.
inline constexpr double longest_subsegment_of_fill = 0.9;

// Returns the distance from the three sites to the nearest point equally far from all three;
// infinite when there is none.
double metric_circumradius(const triangle_sites& t);
// Returns the distance from three sites to the nearest point equally far from them; requires
// coordinates in which the metrics are round.
double circumradius_in_round(const triangle_sites& t);

}  // namespace asterism::internal
