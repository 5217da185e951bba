// SPDX-License-Identifier: MIT
//
// The configurations over which the angle theorem is proved (docs/math/angle-theorem.md).
//
// Three sites a, b, c at metric distance 1 from a point x, in coordinates in which the metric of a
// is the identity, a is (-1, 0) from x, and u = b - x, v = c - x are free: four numbers. The
// metrics of b and c are not variables. What they can do to a length is bounded through the
// distortion that the hypotheses allow at that distance.
#pragma once

#include <array>

#include "asterism/core/interval.hpp"

namespace asterism::internal::angle_theorem {

// The hypotheses, rounded so that the proof covers the numbers as written in decimal.
struct hypotheses {
  double variation = 0;       // sigma R from above
  double spacing = 0;         // lambda / R from below
  double cotangent = 0;       // cotangent of the angle to be proved, rounded down
  double distortion_cap = 0;  // (1 - sigma R)^-2 from above
};

// Makes the hypotheses of decimal numbers given as doubles: sigma R, the ratio R / lambda, and the
// angle in degrees. Requires 0 <= variation < 1/4, 1 <= ratio and 0 < degrees <= 60.
hypotheses make_hypotheses(double variation, double ratio, double degrees);

// A box of configurations: u_x, u_y, v_x, v_y.
struct configuration_box {
  std::array<double, 4> low = {}, high = {};
};

enum class box_verdict {
  // No configuration in the box meets the hypotheses, except mirror images of others.
  excluded,
  // In the whole box the three angles reach the bound in a's metric.
  angles_hold,
  undecided,
};

// Returns what holds for all configurations in the box. Requires a floating_point_scope with
// rounding upward.
box_verdict judge(const configuration_box& box, const hypotheses& given);

}  // namespace asterism::internal::angle_theorem
