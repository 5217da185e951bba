// SPDX-License-Identifier: MIT
//
// Defines unevaluated sums of two doubles, about 106 bits: for plain constructions where the terms
// of a short sum of products cancel more than 53 bits can lose. Nothing certain is built on them.
//
// Rounding to nearest is assumed; products of magnitudes beyond 2^+-960 lose the second half.
// Source: Dekker, "A floating-point technique for extending the available precision", 1971.
#pragma once

#include <cmath>

namespace asterism::internal {

struct double_double {
  double high = 0, low = 0;

  double_double() = default;
  double_double(double x) : high(x) {}  // NOLINT(google-explicit-constructor): every double is one
  explicit operator double() const { return high + low; }

  friend double_double operator-(const double_double& a) { return {-a.high, -a.low}; }
  friend double_double operator+(const double_double& a, const double_double& b) {
    const double sum = a.high + b.high, from_b = sum - a.high;
    const double lost = (a.high - (sum - from_b)) + (b.high - from_b);
    return normalized(sum, lost + (a.low + b.low));
  }
  friend double_double operator-(const double_double& a, const double_double& b) { return a + -b; }
  friend double_double operator*(const double_double& a, const double_double& b) {
    const double product = a.high * b.high;
    const double lost = std::fma(a.high, b.high, -product);
    return normalized(product, lost + (a.high * b.low + a.low * b.high));
  }
  friend bool operator<=(const double_double& a, const double_double& b) {
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
  }

 private:
  double_double(double h, double l) : high(h), low(l) {}
  // Returns h + l as such a sum. Requires |h| >= |l|, approximately.
  static double_double normalized(double h, double l) {
    const double sum = h + l;
    return {sum, l - (sum - h)};
  }
};

}  // namespace asterism::internal
