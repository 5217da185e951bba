// SPDX-License-Identifier: MIT
//
// Rounds sums, products, quotients and square roots upward by arithmetic that rounds to nearest:
// the nearest result, and the double above it where it lies below the exact one. For targets
// without directed rounding (core/directed_rounding.hpp).
//
// Guarantee, in the rounding mode to nearest: each function returns what its operation returns in
// the mode upward, for all doubles, subnormal and infinite ones included. Zeros may differ in their
// signs, and NaN stays NaN. Tests: tests/core/upward_arithmetic_test.cpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

// Included first, as it refuses -ffast-math, for which nothing below would be rigorous.
#include "asterism/core/floating_point_environment.hpp"

namespace asterism::internal::upward {

inline std::int64_t bits_of(double x) { return __builtin_bit_cast(std::int64_t, x); }

// Returns the double above x, the most negative double above minus infinity. Requires x to be no
// NaN and not plus infinity.
inline double next_above(double x) {
  const std::int64_t bits = bits_of(x + 0.0);  // minus zero becomes plus zero
  return __builtin_bit_cast(double, bits + ((bits >> 63) | 1));
}

// True if |x| is a normal number.
inline bool is_normal(double x) {
  constexpr std::uint64_t exponents = 0x7FE, first = 1;
  return ((static_cast<std::uint64_t>(bits_of(x)) >> 52) & 0x7FFU) - first < exponents;
}

// Returns a number with the sign of a * b - p. Requires that a, b and p are normal numbers, and p
// is the product rounded to nearest. Mantissas are taken as whole numbers of 53 bits. In units of
// the last place of the mantissas' product, a * b differs from p by at most half a unit in the last
// place of p, which is at most 2^52 units. The lowest 64 bits of the difference therefore determine
// it, and only these are computed.
inline std::int64_t product_excess(double a, double b, double p) {
  constexpr std::uint64_t leading = std::uint64_t{1} << 52;
  constexpr int bias = 1075;
  const auto mantissa = [](double x) {
    return (static_cast<std::uint64_t>(bits_of(x)) & (leading - 1)) | leading;
  };
  const auto exponent = [](double x) { return static_cast<int>((bits_of(x) >> 52) & 0x7FF); };
  const int shift = exponent(p) - exponent(a) - exponent(b) + bias;  // 52 or 53
  const auto excess = static_cast<std::int64_t>(mantissa(a) * mantissa(b) - (mantissa(p) << shift));
  return p < 0 ? -excess : excess;
}

// Returns the sign of a * b - p for any finite a, b, p of which p is the product rounded to
// nearest. Exponents are taken out first, so that nothing underflows.
[[gnu::noinline]] inline int product_excess_of_any(double a, double b, double p) {
  int of_a = 0, of_b = 0;
  const double a_scaled = std::frexp(a, &of_a), b_scaled = std::frexp(b, &of_b);
  const double product = a_scaled * b_scaled;
  // Subtracts exactly: p is at most 1 in these units, and a multiple of 2^-1074 in its own.
  const double target = std::ldexp(p, -(of_a + of_b));
  if (product != target) return product > target ? 1 : -1;
  if (product == 0) return 0;
  const std::int64_t excess = product_excess(a_scaled, b_scaled, product);
  return excess > 0 ? 1 : excess < 0 ? -1 : 0;
}

// Returns the sign of a * b - c exactly. Requires finite numbers. Rounding keeps the order, so that
// the rounded product decides unless it is c itself.
inline int compare_product(double a, double b, double c) {
  const double p = a * b;
  return p != c ? (p > c ? 1 : -1) : product_excess_of_any(a, b, p);
}

inline bool is_finite(double x) { return std::abs(x) <= std::numeric_limits<double>::max(); }

// Returns the sum rounded upward. The exact error of a sum rounded to nearest is a double, which
// smaller - (nearest - greater) computes exactly (Dekker, "A floating-point technique for extending
// the available precision", 1971). An infinite sum is correct too: rounded upward, -infinity
// becomes the double above it.
inline double sum(double a, double b) {
  const double nearest = a + b;
  const bool ordered = std::abs(a) >= std::abs(b);
  const double greater = ordered ? a : b, smaller = ordered ? b : a;
  const double error = smaller - (nearest - greater);
  return error > 0 ? next_above(nearest) : nearest;
}

[[gnu::noinline]] inline double product_of_any(double a, double b, double nearest) {
  if (!is_finite(a) || !is_finite(b)) return nearest;
  if (!is_finite(nearest)) return nearest > 0 ? nearest : next_above(nearest);
  return product_excess_of_any(a, b, nearest) > 0 ? next_above(nearest) : nearest;
}

inline double product(double a, double b) {
  const double nearest = a * b;
  if (is_normal(a) & is_normal(b) & is_normal(nearest))
    return product_excess(a, b, nearest) > 0 ? next_above(nearest) : nearest;
  return a == 0 || b == 0 ? nearest : product_of_any(a, b, nearest);
}

inline double quotient(double a, double b) {
  const double nearest = a / b;
  if (a == 0 || b == 0 || !is_finite(a) || !is_finite(b)) return nearest;
  if (!is_finite(nearest)) return nearest > 0 ? nearest : next_above(nearest);
  const int excess = compare_product(nearest, b, a);
  return (b > 0 ? excess < 0 : excess > 0) ? next_above(nearest) : nearest;
}

// Returns the root rounded upward; NaN for a negative number.
inline double root(double x) {
  const double nearest = std::sqrt(x);
  if (!is_finite(x) || !is_finite(nearest)) return nearest;
  return compare_product(nearest, nearest, x) < 0 ? next_above(nearest) : nearest;
}

}  // namespace asterism::internal::upward
