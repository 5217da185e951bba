// SPDX-License-Identifier: MIT
//
// Finds the narrowest interval of doubles around a dyadic number: a point when the number is a
// double, else one unit in the last place wide, or wider beyond the exponents of normal doubles.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/interval.hpp"

namespace asterism::internal {

inline interval enclose(const dyadic& x) {
  if (x.is_zero()) return interval(0);
  constexpr int double_bits = 53, limb_bits = 64;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool negative = x.sign_value() == sign::negative;
  const auto between = [negative](double near, double away) {
    return negative ? interval(-away, -near) : interval(near, away);
  };
  // Returns the exponent with 2^(exponent - 1) <= |x| < 2^exponent.
  const long exponent = x.magnitude();
  constexpr long largest = 1000;
  if (exponent > largest) return between(0x1p999, infinity);
  if (exponent < -largest) return between(0, 0x1p-999);
  const auto limbs = x.mantissa().limbs();
  const int zeros = std::countl_zero(limbs.back());
  std::uint64_t leading = limbs.back() << zeros;
  if (zeros > 0 && limbs.size() > 1) leading |= limbs[limbs.size() - 2] >> (limb_bits - zeros);
  // Takes the leading bits as the fraction of a normal double; the next double has the next bit
  // pattern.
  constexpr long bias = 1022;
  constexpr std::uint64_t fraction_mask = (std::uint64_t{1} << (double_bits - 1)) - 1;
  const std::uint64_t pattern = (static_cast<std::uint64_t>(exponent + bias) << (double_bits - 1)) |
                                ((leading >> (limb_bits - double_bits)) & fraction_mask);
  const double near_zero = std::bit_cast<double>(pattern);
  const long bits = x.mantissa().bit_length() - static_cast<long>(x.mantissa().trailing_zeros());
  return between(near_zero, bits <= double_bits ? near_zero : std::bit_cast<double>(pattern + 1));
}

// Returns an interval around the number. arc_search calls this if its coefficients are exact and
// its signs intervals.
template <class Number>
requires std::is_same_v<Number, interval> interval number_as(const dyadic& x) { return enclose(x); }

}  // namespace asterism::internal
