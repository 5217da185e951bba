// SPDX-License-Identifier: MIT
//
// Names the auditor's two arithmetics: a double that carries a bound of its error
// (kernels/bounded.hpp), and rationals.
#pragma once

#include <cmath>
#include <limits>

#include "asterism/core/site.hpp"
#include "asterism/kernels/bounded.hpp"
#include "asterism/mesh/support/rational.hpp"

namespace asterism::internal::audit_detail {

using internal::rational;

// Return the greater of two upper bounds, and a lower bound if it is positive, else 0: a NaN, which
// an overflow leaves, bounds nothing.
inline double greatest_bound(double a, double b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return a < infinity && b < infinity ? (a > b ? a : b) : infinity;
}
inline double positive_bound(double a) { return a > 0 ? a : 0; }

template <class Number>
struct vector2 {
  Number x, y;
};

template <class Number>
Number cross(const vector2<Number>& a, const vector2<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Number>
struct tensor {
  Number m11, m12, m22;

  Number determinant() const { return m11 * m22 - m12 * m12; }
  vector2<Number> operator*(const vector2<Number>& a) const {
    return {m11 * a.x + m12 * a.y, m12 * a.x + m22 * a.y};
  }
};

inline tensor<bounded> tensor_of_doubles(const metric_tensor& m) {
  return {bounded(m.m11), bounded(m.m12), bounded(m.m22)};
}

template <class Number>
Number dot(const vector2<Number>& a, const vector2<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

}  // namespace asterism::internal::audit_detail
