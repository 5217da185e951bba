// SPDX-License-Identifier: MIT
//
// Defines values in plain doubles that come with a bound of their error.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal::audit_detail {

// A value with its size, at least the sum of its absolute monomials: the value's error is below
// 2^-48 of the size in any rounding mode, where nothing underflows.
struct sized_value {
  double value, size;

  double below() const { return value - 0x1p-46 * size; }
};

// Returns the square of u's length in the metric m, with its size.
inline sized_value sized_square_norm(const metric_tensor& m, const point& u) {
  const double unmixed = m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y), mixed = m.m12 * (u.x * u.y);
  return {unmixed + 2 * mixed, 2 * unmixed};
}

inline sized_value sized_determinant(const metric_tensor& m) {
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  return {product - square, product + square};
}

}  // namespace asterism::internal::audit_detail
