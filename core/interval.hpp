// SPDX-License-Identifier: MIT
//
// Rigorous enclosures by doubles: CGAL's Interval_nt without protection of its own, so every use
// stands in a floating_point_scope(rounding::upward).
//
// An overflow gives an infinite or meaningless bound; no comparison with those is ever certain.
#pragma once

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/core/sign.hpp"

namespace asterism {

using interval = CGAL::Interval_nt<false>;

inline uncertain_sign sign_of(const interval& x) {
  constexpr double largest = std::numeric_limits<double>::max();
  // Written so that a NaN bound falls through to "undecided".
  if (!(x.inf() >= -largest && x.sup() <= largest)) return {};
  if (x.inf() > 0) return sign::positive;
  if (x.sup() < 0) return sign::negative;
  if (x.inf() == 0 && x.sup() == 0) return sign::zero;
  return {};
}

// The square root of the part of x that is not negative: for a radicand known to be non-negative
// whose enclosure is not.
inline interval square_root_of_non_negative(const interval& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(x.sup() >= 0)) return interval(0, infinity);  // empty, or a NaN: promise nothing
  return CGAL::sqrt(interval(std::max(0.0, x.inf()), x.sup()));
}

}  // namespace asterism
