// SPDX-License-Identifier: MIT
//
// Defines numbers with the digits of two doubles and an exponent of their own, for products of four
// or more doubles that leave the range of doubles. A long double is different on other machines;
// these have the same bits everywhere. Nothing certain is built on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "asterism/mesh/support/double_double.hpp"

namespace asterism::internal {

class wide_range {
 public:
  wide_range() = default;
  wide_range(double x) : wide_range(double_double(x), 0) {}  // NOLINT(google-explicit-constructor)

  // Converts to a double: infinity, zero or a subnormal number outside of the range of normal
  // doubles.
  explicit operator double() const { return std::ldexp(static_cast<double>(mantissa_), exponent_); }
  bool is_positive() const { return mantissa_.high > 0; }

  friend wide_range operator-(const wide_range& a) { return {-a.mantissa_, a.exponent_}; }
  friend wide_range operator+(const wide_range& a, const wide_range& b) {
    if (a.mantissa_.high == 0) return b;
    if (b.mantissa_.high == 0) return a;
    const int exponent = std::max(a.exponent_, b.exponent_);
    return {a.aligned(exponent) + b.aligned(exponent), exponent};
  }
  friend wide_range operator-(const wide_range& a, const wide_range& b) { return a + -b; }
  friend wide_range operator*(const wide_range& a, const wide_range& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  // Divides with the relative error of a division of doubles.
  friend wide_range operator/(const wide_range& a, const wide_range& b) {
    return {double_double(a.mantissa_.high / b.mantissa_.high), a.exponent_ - b.exponent_};
  }
  // Returns the root of max(0, a), with the relative error of a root of doubles.
  friend wide_range root(const wide_range& a) {
    if (!a.is_positive()) return a.mantissa_.high == a.mantissa_.high ? wide_range() : a;
    const int odd = a.exponent_ % 2 == 0 ? 0 : 1;
    const double r = std::sqrt(std::ldexp(static_cast<double>(a.mantissa_), odd));
    return {double_double(r), (a.exponent_ - odd) / 2};
  }

  // Two numbers divided by one power of two, so that the larger is a double near 1.
  struct scaled_pair {
    double first = 0, second = 0;
  };
  friend scaled_pair scaled(const wide_range& a, const wide_range& b) {
    const int exponent = a.mantissa_.high == 0   ? b.exponent_
                         : b.mantissa_.high == 0 ? a.exponent_
                                                 : std::max(a.exponent_, b.exponent_);
    return {static_cast<double>(a.aligned(exponent)), static_cast<double>(b.aligned(exponent))};
  }

 private:
  wide_range(const double_double& m, int exponent) {
    if (m.high == 0 || !std::isfinite(m.high)) {
      mantissa_ = m;
      return;
    }
    const int shift = std::ilogb(m.high);
    mantissa_ = scaled_by(m, -shift);
    exponent_ = exponent + shift;
  }
  static double_double scaled_by(const double_double& m, int shift) {
    double_double result(std::ldexp(m.high, shift));
    result.low = std::ldexp(m.low, shift);
    return result;
  }
  double_double aligned(int exponent) const {
    constexpr int far = -4000;  // no double is left of it
    return scaled_by(mantissa_, std::max(exponent_ - exponent, far));
  }

  double_double mantissa_;  // its size in [1, 2), or zero or not finite
  int exponent_ = 0;
};

}  // namespace asterism::internal
