// SPDX-License-Identifier: MIT
//
// Shares what bounds of errors of doubles, made in doubles themselves, have in common.
#pragma once

#include <algorithm>

#include "asterism/core/rounded_interval.hpp"

namespace asterism::internal {

// More than the few roundings of a bound of an error itself, in which each changes it by 2^-53.
inline constexpr double slack = 1 + 0x1p-40;

struct middle_and_half {
  double middle, half;
};

// Returns a double of the interval, and what the interval reaches to either side of it, rounded as
// the mode in force says.
inline middle_and_half parted(const rounded_interval& a) {
  const double low = a.inf(), high = a.sup();
  const double middle = low == high ? low : low + (high - low) / 2;
  return {middle, std::max(high - middle, middle - low)};
}

}  // namespace asterism::internal
