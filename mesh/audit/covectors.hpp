// SPDX-License-Identifier: MIT
//
// Measures covectors in metrics: for a covector g, |g|_M^2 = g M^-1 g.
//
// Errors. An operation in any rounding mode is off by at most 2^-52 of its result. `step` times the
// sum of the absolute values of a value's monomials bounds eight roundings of each, and those of
// the bound itself; `up` bounds the three or four roundings after that.
#pragma once

#include <cmath>

#include "asterism/core/site.hpp"
#include "asterism/kernels/two_doubles.hpp"

namespace asterism::internal::audit_detail {

namespace roundings {
constexpr double step = 0x1p-48, up = 1 + 0x1p-49;
}  // namespace roundings

// One number for each of the covectors x, y, x + y and x - y.
struct by_covector {
  two_doubles axes, diagonals;

  friend by_covector operator+(const by_covector& a, const by_covector& b) {
    return {a.axes + b.axes, a.diagonals + b.diagonals};
  }
  friend by_covector operator-(const by_covector& a, const by_covector& b) {
    return {a.axes - b.axes, a.diagonals - b.diagonals};
  }
  friend by_covector operator*(const by_covector& a, const by_covector& b) {
    return {a.axes * b.axes, a.diagonals * b.diagonals};
  }
  friend by_covector operator/(const by_covector& a, const by_covector& b) {
    return {a.axes / b.axes, a.diagonals / b.diagonals};
  }
  friend by_covector operator-(const by_covector& a) { return {-a.axes, -a.diagonals}; }
};

inline by_covector all_of(double x) { return {both(x), both(x)}; }
// Returns the values at q; those of the diagonals are rounded.
inline by_covector values_at(const point& q) {
  return {pair(q.x, q.y), pair(q.x + q.y, q.x - q.y)};
}
// Return the second number where one is not a number.
inline double greater_of(double a, double b) { return a > b ? a : b; }
inline by_covector greater_of(const by_covector& a, const by_covector& b) {
  return {greatest(a.axes, b.axes), greatest(a.diagonals, b.diagonals)};
}

// Returns a lower bound of the determinant; 0 where none is known.
double determinant_below(const metric_tensor& m);
// Returns an upper bound of 1 / det m; infinite where the determinant is not certainly positive.
double inverse_determinant_above(const metric_tensor& m);

// The next three take an upper bound of 1 / det m, and are infinite where it is.
// Returns upper bounds of the squares of the lengths of the four covectors.
by_covector squared_lengths(const metric_tensor& m, double inverse_determinant);
// Returns upper bounds of roots that are not too small.
by_covector roots_above(const by_covector& squares);
// Returns an upper bound of the length of g.
inline double length_above(const point& g, const metric_tensor& m, double inverse_determinant) {
  using roundings::step;
  using roundings::up;
  const double xx = m.m22 * g.x * g.x, yy = m.m11 * g.y * g.y, xy = 2 * (m.m12 * g.x * g.y);
  const double square = xx + yy - xy + step * (xx + yy + std::abs(xy));
  return std::sqrt((square + 0x1p-300) * inverse_determinant) * (up * up);
}

}  // namespace asterism::internal::audit_detail
