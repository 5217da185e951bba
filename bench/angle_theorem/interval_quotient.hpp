// SPDX-License-Identifier: MIT
//
// Quotients of intervals, which the library itself does not need.
#pragma once

#include <algorithm>
#include <limits>

#include "asterism/core/interval.hpp"

namespace asterism::internal {

// Returns an interval that holds all quotients of a number of `a` and one of `b`; everything where
// `b` holds zero. Requires rounding upward: minus the lower end is the greatest of the quotients of
// the negated numerators.
inline interval operator/(const interval& a, const interval& b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (b.inf() <= 0 && b.sup() >= 0) return {-infinity, infinity};
  const double high =
      std::max({rounded_quotient(a.inf(), b.inf()), rounded_quotient(a.inf(), b.sup()),
                rounded_quotient(a.sup(), b.inf()), rounded_quotient(a.sup(), b.sup())});
  const double minus_low =
      std::max({rounded_quotient(-a.inf(), b.inf()), rounded_quotient(-a.inf(), b.sup()),
                rounded_quotient(-a.sup(), b.inf()), rounded_quotient(-a.sup(), b.sup())});
  return {-minus_low, high};
}

}  // namespace asterism::internal
