// SPDX-License-Identifier: MIT
//
// Rounds rationals, their square roots, and cotangents to some number of bits, in a direction.
// Everything is done in whole numbers; inside the auditor alone.
#pragma once

#include "asterism/mesh/support/rational.hpp"

namespace asterism::internal::audit_detail {

enum class direction { down, up };

// The real number mantissa * 2^exponent.
struct binary_number {
  whole_number mantissa;
  long exponent = 0;
};

// Returns a rational >= 0, rounded to `bits` bits in the direction given.
binary_number rounded(const rational& number, unsigned bits, direction to);
// Does the same with a quotient that need not be in lowest terms. Requires a denominator above 0.
binary_number rounded_quotient(const whole_number& numerator, const whole_number& denominator,
                               unsigned bits, direction to);
// Returns the square root of a rational >= 0, rounded to `bits` bits in the direction given.
binary_number rounded_root(const binary_number& square, unsigned bits, direction to);

rational as_rational(const binary_number& number);
// Returns the double next to the rational in the direction given, or equal to it. Upward, infinity
// where that overflows.
double as_double(const binary_number& number, direction to);

// Bounds of cot^2 of an angle, each with an error below 2^-190 of it.
struct cotangent_bounds {
  rational low, high;
};
// Requires an angle above 0 and below 90 degrees.
cotangent_bounds squared_cotangent_of(double degrees);

}  // namespace asterism::internal::audit_detail
