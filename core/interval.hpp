// SPDX-License-Identifier: MIT
//
// Rigorous enclosures by doubles: CGAL's Interval_nt without protection of its own, so every use
// stands in a floating_point_scope(rounding::upward).
//
// In the self-check build (ASTERISM_SELF_CHECK) every interval carries its exact shadow instead
// (core/shadowed_interval.hpp).
//
// An overflow gives an infinite or meaningless bound; no comparison with those is ever certain.
#pragma once

// First: it refuses -ffast-math, for which nothing below would be rigorous.
#include "asterism/core/floating_point_environment.hpp"

#ifdef ASTERISM_SELF_CHECK
#include "asterism/core/shadowed_interval.hpp"
#else
#include <CGAL/Interval_nt.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/core/sign.hpp"

namespace asterism::internal {

using asterism::sign_of;  // of a double, beside those below

#ifdef ASTERISM_SELF_CHECK
using interval = shadowed_interval;
#else
using interval = CGAL::Interval_nt<false>;

inline interval squared(const interval& x) { return CGAL::square(x); }
inline interval root_of_non_negative(const interval& x) {
  return CGAL::sqrt(interval(std::max(0.0, x.inf()), x.sup()));
}
#endif

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
  return root_of_non_negative(x);
}

}  // namespace asterism::internal
