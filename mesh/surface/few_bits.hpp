// SPDX-License-Identifier: MIT
//
// Rounds numbers that decide which mesh is made. Decisions by their last digits would make another
// mesh for each order of summation: two builds had 1253 and 1340 vertices of one surface.
#pragma once

#include <cmath>

namespace asterism::internal {

// Returns x >= 0 to 12 bits, rounded up: by at most a 2048th.
inline double in_few_bits(double x) {
  constexpr double steps = 4096;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::ceil(mantissa * steps) / steps, exponent);
}

// Returns x as a multiple of the power of two about 2^-20 times `scale` > 0.
inline double in_steps_of(double x, double scale) {
  const double step = std::ldexp(1.0, std::ilogb(scale) - 20);
  return std::round(x / step) * step;
}

}  // namespace asterism::internal
