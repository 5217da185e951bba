// SPDX-License-Identifier: MIT
//
// Cuts the curves that trim a patch at their knots, and refuses invalid ones by name.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface_audit/space_algebra.hpp"

namespace asterism::internal {

// Returns the fault of a patch's loops in half a sentence, or nothing: a loop without curves,
// degrees above the greatest, numbers and weights out of a patch's ranges.
std::optional<std::string> fault_of_trims(const surface_patch& p, int greatest_degree);

// Refers to a curve of a patch, with the number of the next curve in its loop.
struct trim_link {
  const trim_curve* curve = nullptr;
  std::size_t next = 0;
};
// Returns the curves of all loops in order.
std::vector<trim_link> trims_of(const surface_patch& p);

// Returns u and v at a place from 0 to 1, in doubles. At 0 and 1 they are those of the first and
// the last control point.
std::array<double, 2> trim_at(const trim_curve& c, double place);
// Returns the places of the inner knots, rounded.
std::vector<double> knot_places(const trim_curve& c);

// A part of a curve that is one polynomial, or one quotient, from place `low` to `high`. Its Bezier
// points are (w u, w v, 0) and w.
struct trim_piece {
  rounded_interval low, high;
  std::vector<weighted_point> points;

  int degree() const { return static_cast<int>(points.size()) - 1; }
};
// Returns the parts of a curve between its knots. Requires a curve without fault, and a
// floating_point_scope(rounding::upward).
std::vector<trim_piece> trim_pieces(const trim_curve& c);

}  // namespace asterism::internal
