// SPDX-License-Identifier: MIT
//
// Cuts rows of control points at their knots into Bezier points.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/surface_audit/space_algebra.hpp"

namespace asterism::internal {

// True for 0 and for numbers whose products stay in the range of doubles (number_ranges.hpp).
bool is_in_range(double x);

// Returns the fault of a direction's knots in half a sentence, or nothing.
std::optional<std::string> fault_of_knots(const std::vector<double>& knots, int degree,
                                          std::size_t count, char direction);

// A row or column of control points between two knots: `degree` + 1 points of a curve, and the
// knots around them.
struct span_of_knots {
  double low = 0, high = 1;
  std::size_t first = 0;                // its first control point
  std::vector<rounded_interval> knots;  // 2 degree: t_{first + 1} to t_{first + 2 degree}
};

// Returns the spans between knots without fault. Without knots there is one span, from 0 to 1.
std::vector<span_of_knots> spans_of_knots(const std::vector<double>& knots, int degree);

// Returns the Bezier points of the span from its control points, which begin the list `c`. Requires
// a floating_point_scope(rounding::upward).
std::vector<weighted_point> bezier_points(const std::vector<weighted_point>& c,
                                          const span_of_knots& s, int degree);

}  // namespace asterism::internal
