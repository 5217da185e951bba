// SPDX-License-Identifier: MIT
//
// Question: where does y lie against the ellipse through v, w, x that is a circle in the metric m?
// Computes: sign of the in-circle determinant with |u|^2 replaced by u^T m u; degree 4 in
//   coordinate differences, 1 in the metric.
// Returns: positive: y inside when v w x turn counter-clockwise (outside when clockwise); negative:
//   the other way round; zero: the four are cocircular in m, or collinear.
// Laws: 1. even permutations of v w x y keep the sign, odd ones negate it; 2. with m the identity
//   it is the usual in-circle test.
// Requires: finite numbers, m positive definite.
// Degenerate: zero is an answer; edge_test breaks the tie.
// Source: what INSERTIONTEST becomes when all four metrics are equal (docs/math/insertion-test.md).
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

template <class Number>
Number in_circle_value(const basic_metric_tensor<Number>& m, const basic_point<Number>& v,
                       const basic_point<Number>& w, const basic_point<Number>& x,
                       const basic_point<Number>& y) {
  const auto a = between(y, v), b = between(y, w), c = between(y, x);
  return squared_length(m, a) * cross(b, c) + squared_length(m, b) * cross(c, a) +
         squared_length(m, c) * cross(a, b);
}

template <class Number>
uncertain_sign in_circle(const basic_metric_tensor<Number>& m, const basic_point<Number>& v,
                         const basic_point<Number>& w, const basic_point<Number>& x,
                         const basic_point<Number>& y) {
  return sign_of(in_circle_value(m, v, w, x, y));
}

// Returns (x - v)^T m (x - w): the cotangent, in m, of the angle at x between v and w, times the
// double area of v, w, x.
template <class Number>
Number angle_value(const basic_metric_tensor<Number>& m, const basic_point<Number>& v,
                   const basic_point<Number>& w, const basic_point<Number>& x) {
  return dot(between(v, x), apply(m, between(w, x)));
}

// Computes the polynomial of in_circle_value from the orientations of v, w, x and of v, w, y, which
// the caller has already: opposite angles, whose cotangents add up to zero on a circle.
template <class Number>
Number opposite_angles_value(const basic_metric_tensor<Number>& m, const basic_point<Number>& v,
                             const basic_point<Number>& w, const basic_point<Number>& x,
                             const basic_point<Number>& y, const Number& orientation_x,
                             const Number& orientation_y) {
  return angle_value(m, v, w, x) * orientation_y - angle_value(m, v, w, y) * orientation_x;
}

}  // namespace asterism::internal
