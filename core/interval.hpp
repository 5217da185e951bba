// SPDX-License-Identifier: MIT
//
// Names the interval type of the kernels, rigorous enclosures by doubles. Every use must be in a
// floating_point_scope(rounding::upward).
//
// The type is rounded_interval. In the self-check build (ASTERISM_SELF_CHECK) it is
// shadowed_interval, which carries its exact shadow.
//
// An overflow gives an infinite or meaningless bound; no comparison with those is ever certain.
#pragma once

// Included first, as it refuses -ffast-math, for which nothing below would be rigorous.
#include "asterism/core/floating_point_environment.hpp"

#ifdef ASTERISM_SELF_CHECK
#include "asterism/core/shadowed_interval.hpp"
#else
#include "asterism/core/rounded_interval.hpp"
#endif

#include <limits>

#include "asterism/core/sign.hpp"

namespace asterism::internal {

using asterism::sign_of;  // of a double, beside those below

#ifdef ASTERISM_SELF_CHECK
using interval = shadowed_interval;
#else
using interval = rounded_interval;
#endif

inline uncertain_sign sign_of(const interval& x) {
  constexpr double largest = std::numeric_limits<double>::max();
  // Compares so that a NaN bound leads to "undecided".
  if (!(x.inf() >= -largest && x.sup() <= largest)) return {};
  if (x.inf() > 0) return sign::positive;
  if (x.sup() < 0) return sign::negative;
  if (x.inf() == 0 && x.sup() == 0) return sign::zero;
  return {};
}

// Returns the square root of the part of x that is not negative: for a radicand known to be
// non-negative whose enclosure contains negative numbers.
inline interval square_root_of_non_negative(const interval& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(x.sup() >= 0)) return interval(0, infinity);  // empty, or a NaN: promise nothing
  return root_of_non_negative(x);
}

}  // namespace asterism::internal
