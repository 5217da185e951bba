// SPDX-License-Identifier: MIT
//
// Holds the steps common to bounds of errors that are computed in doubles themselves.
#pragma once

#include <algorithm>

#include "asterism/core/rounded_interval.hpp"

namespace asterism::internal {

// Upper bound of (1 + 2^-53)^k for k up to 2^12: the factor by which the roundings of an error
// bound may reduce it.
inline constexpr double slack = 1 + 0x1p-40;

struct middle_and_half {
  double middle, half;
};

// Returns a double inside the interval, and the distance of the interval's farther end from it,
// rounded by the present rounding mode.
inline middle_and_half parted(const rounded_interval& a) {
  const double low = a.inf(), high = a.sup();
  const double middle = low == high ? low : low + (high - low) / 2;
  return {middle, std::max(high - middle, middle - low)};
}

}  // namespace asterism::internal
