// SPDX-License-Identifier: MIT
//
// Defines a double that carries a bound of its error, for formulas whose bound is not worth
// deriving by hand. Each operation costs about as much as ten of doubles.
//
// `bounded` never changes the rounding mode and trusts none: every bound below holds whichever way
// the machine rounds, and whether or not it flushes subnormal numbers to zero.
#pragma once

#include <cmath>
#include <limits>

#include "asterism/core/floating_point_environment.hpp"  // refuses -ffast-math

namespace asterism::internal {

// The exact value lies within `error` of `value`. Results beyond 2^1000 have an infinite error, so
// that nothing is certain any more: a test for infinities would not suffice, since an overflow
// rounded towards zero is the largest double.
//
// An operation in any rounding mode is off by at most 2^-52 of its result, or 2^-1022 where that is
// subnormal. `inflated` adds 2^-51 of the result and 2^-1000 instead: the difference covers the few
// roundings of the bound itself.
class bounded {
 public:
  bounded() = default;
  bounded(double exact) : value_(exact), error_(std::abs(exact) < smallest ? smallest : 0) {}
  static bounded within(double value, double error) { return {value, error}; }

  double value() const { return value_; }
  double error() const { return error_; }
  bool certainly_positive() const { return value_ > error_; }
  bool certainly_negative() const { return -value_ > error_; }
  double upper() const { return (value_ + error_) + slack(); }
  double lower() const { return (value_ - error_) - slack(); }

  friend bounded operator-(bounded a) { return {-a.value_, a.error_}; }
  friend bounded operator+(bounded a, bounded b) {
    return inflated(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend bounded operator-(bounded a, bounded b) { return a + -b; }
  friend bounded operator*(bounded a, bounded b) {
    return inflated(a.value_ * b.value_, std::abs(a.value_) * b.error_ +
                                             std::abs(b.value_) * a.error_ + a.error_ * b.error_);
  }
  friend bounded operator/(bounded a, bounded b) {
    // Bounds the exact |b| from below by subtracting b's error twice: once for the error itself,
    // once for the roundings of this line.
    const double divisor = std::abs(b.value_) - 2 * b.error_;
    const double quotient = a.value_ / b.value_;
    if (!(divisor > smallest)) return {quotient, std::numeric_limits<double>::infinity()};
    return inflated(quotient, (a.error_ + std::abs(quotient) * b.error_) / divisor);
  }
  // Returns the root of max(0, a).
  friend bounded root(bounded a) {
    if (a.certainly_positive()) {
      const double r = std::sqrt(a.value_);
      return inflated(r, a.error_ / r);
    }
    const double top = a.upper();
    if (!(top <= std::numeric_limits<double>::max()))  // infinite or not a number
      return {0, std::numeric_limits<double>::infinity()};
    const double half = std::sqrt(std::fmax(0, top)) / 2;
    return inflated(half, half);
  }

 private:
  static constexpr double smallest = 0x1p-1000;
  static constexpr double largest = 0x1p1000;
  static constexpr double step = 0x1p-51;

  bounded(double value, double error) : value_(value), error_(error) {}
  static bounded inflated(double value, double error) {
    const double bound = (error + std::abs(value) * step) * (1 + 16 * step) + smallest;
    const bool in_range = std::abs(value) + bound <= largest;
    return {value, in_range ? bound : std::numeric_limits<double>::infinity()};
  }
  double slack() const { return (std::abs(value_) + error_) * step + smallest; }

  double value_ = 0, error_ = 0;
};

inline bool certainly_less(bounded a, bounded b) { return (b - a).certainly_positive(); }

}  // namespace asterism::internal
