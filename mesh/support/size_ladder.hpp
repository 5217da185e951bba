// SPDX-License-Identifier: MIT
//
// Lists the size factors that a run with a guarantee tries, and a certificate may name.
#pragma once

namespace asterism::internal {

// Ratio of one size to the next: the first step that suffices takes at most 1.69 times the sites of
// the least factor that does.
inline constexpr double ladder_ratio = 1.3;
// Largest step of the ladder: 1.3^160 is 2^60, and edges shorter by that factor have no room among
// doubles.
inline constexpr int ladder_steps = 160;

// Returns the factor of a step: ladder_ratio to the power of the step, each product rounded.
constexpr double ladder_factor(int step) {
  double factor = 1;
  for (int i = 0; i < step; ++i) factor *= ladder_ratio;
  return factor;
}

// Returns the last step from 0 on whose factor is not above `factor`.
constexpr int ladder_step_below(double factor) {
  int step = 0;
  while (step < ladder_steps && ladder_factor(step + 1) <= factor) ++step;
  return step;
}

}  // namespace asterism::internal
