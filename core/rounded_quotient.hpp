// SPDX-License-Identifier: MIT
//
// Adds to rounded intervals their quotients by positive numbers, and hulls. Both require a
// floating_point_scope(rounding::upward), as core/rounded_interval.hpp says.
#pragma once

#include <algorithm>

#include "asterism/core/rounded_interval.hpp"

namespace asterism::internal {

// Returns an enclosure of a / b. Requires b.inf() > 0. Each end is the quotient of that end of a by
// the end of b that moves it outward.
inline rounded_interval quotient(const rounded_interval& a, const rounded_interval& b) {
  const double low = a.inf(), high = a.sup();
  return {-rounded_quotient(-low, low >= 0 ? b.sup() : b.inf()),
          rounded_quotient(high, high >= 0 ? b.inf() : b.sup())};
}

inline rounded_interval hull(const rounded_interval& a, const rounded_interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}

}  // namespace asterism::internal
