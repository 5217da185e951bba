// SPDX-License-Identifier: MIT
//
// Computes logarithms and exponentials to 1e-13, for building metrics, which takes thousands of
// them and does not need the last digits: a fifth of the work of core/elementary.hpp. The same bits
// on every machine, as there. Decides nothing.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {

// Returns ln x. Error: 1e-13, absolute or relative, whichever is more.
inline double quick_log(double x) {
  constexpr double least_normal = 0x1p-1022, most = 0x1p1023;
  if (!(x >= least_normal && x <= most)) return elementary::log(x);
  constexpr int mantissa_bits = 52;
  // Takes the mantissa in [root 1/2, root 2].
  constexpr auto root_half = std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp-1);
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto exponent = static_cast<std::int64_t>(bits - root_half) >> mantissa_bits;
  const double mantissa =
      std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << mantissa_bits));
  // Sums the series of ln m = 2 artanh s. The terms left out are below 2 s^17 / 16, with |s| <=
  // 0.1716: 1.2e-14.
  const double s = (mantissa - 1) / (mantissa + 1), q = s * s;
  const double series =
      2.0 +
      q * (2.0 / 3 +
           q * (2.0 / 5 +
                q * (2.0 / 7 + q * (2.0 / 9 + q * (2.0 / 11 + q * (2.0 / 13 + q * (2.0 / 15)))))));
  return static_cast<double>(exponent) * std::numbers::ln2 + s * series;
}

// Returns e^x. Relative error: 1e-13 for |x| up to 300.
inline double quick_exp(double x) {
  constexpr double most = 300;
  if (!(std::abs(x) <= most)) return elementary::exp(x);
  const auto power = static_cast<std::int64_t>(x * std::numbers::log2e + (x < 0 ? -0.5 : 0.5));
  // Reduces the argument. ln 2 and its product with the power are rounded, each with an error of
  // 2^-53 of at most 300: 7e-14 together.
  const double r = x - static_cast<double>(power) * std::numbers::ln2;
  // Sums the series of the exponential. The terms left out are below 2 r^12 / 12!, with |r| <=
  // 0.347: 1.3e-14.
  const double series =
      1 +
      r * (1 +
           r * (1.0 / 2 +
                r * (1.0 / 6 +
                     r * (1.0 / 24 +
                          r * (1.0 / 120 +
                               r * (1.0 / 720 +
                                    r * (1.0 / 5040 + r * (1.0 / 40320 +
                                                           r * (1.0 / 362880 +
                                                                r * (1.0 / 3628800 +
                                                                     r * (1.0 / 39916800)))))))))));
  constexpr std::int64_t bias = 1023, mantissa_bits = 52;
  return series * std::bit_cast<double>(static_cast<std::uint64_t>(power + bias) << mantissa_bits);
}

}  // namespace asterism::internal
