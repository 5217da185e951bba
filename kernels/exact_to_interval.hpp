// SPDX-License-Identifier: MIT
//
// The narrowest interval of doubles around a dyadic number: a point when the number is a double,
// else one unit in the last place wide, or wider beyond the exponents of normal doubles.
#pragma once

#include <cmath>
#include <limits>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/interval.hpp"

namespace asterism {

inline interval enclose(const dyadic& x) {
  if (x.is_zero()) return interval(0);
  long exponent = 0;
  // Truncated towards zero, half <= |fraction| < 1.
  const double fraction = mpz_get_d_2exp(&exponent, x.mantissa().backend().data());
  exponent += x.exponent();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr long largest = 1000;
  if (exponent > largest)
    return fraction > 0 ? interval(0x1p999, infinity) : interval(-infinity, -0x1p999);
  if (exponent < -largest) return fraction > 0 ? interval(0, 0x1p-999) : interval(-0x1p-999, 0);
  const int shift = static_cast<int>(exponent);
  const double near_zero = std::ldexp(fraction, shift);
  constexpr long double_bits = 53;
  const auto* mantissa = x.mantissa().backend().data();
  const long bits =
      static_cast<long>(mpz_sizeinbase(mantissa, 2)) - static_cast<long>(mpz_scan1(mantissa, 0));
  if (bits <= double_bits) return interval(near_zero);
  const double away = std::ldexp(fraction + (fraction > 0 ? 0x1p-53 : -0x1p-53), shift);
  return fraction > 0 ? interval(near_zero, away) : interval(away, near_zero);
}

// Used by arc_search for exact coefficients with interval signs.
template <class Number>
requires std::is_same_v<Number, interval> interval number_as(const dyadic& x) { return enclose(x); }

}  // namespace asterism
