// SPDX-License-Identifier: MIT
//
// Lists the size factors that a run with a guarantee tries, and a certificate may name.
#pragma once

namespace asterism::internal {

// Ratio of one size factor to the next: a mesh with the first factor on the ladder that suffices
// has at most 1.69 times the sites of a mesh with the least real factor that suffices.
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

// Returns the greatest step of the ladder whose factor is at most `factor`; 0 if there is none.
constexpr int ladder_step_below(double factor) {
  int step = 0;
  while (step < ladder_steps && ladder_factor(step + 1) <= factor) ++step;
  return step;
}

}  // namespace asterism::internal
