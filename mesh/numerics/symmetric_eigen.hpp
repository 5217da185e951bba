// SPDX-License-Identifier: MIT
//
// Computes eigenvalues and eigenvectors of symmetric 2x2 matrices, of either sign. In doubles, for
// building metrics; decides nothing.
#pragma once

#include <algorithm>
#include <cmath>

#include "asterism/core/site.hpp"
#include "asterism/mesh/numerics/scaled_tensor.hpp"

namespace asterism::internal {

// A symmetric matrix as first n n^T + second t t^T, with n = (c, s) and t = (-s, c). `first` is the
// greater.
struct symmetric_eigen {
  double first = 0, second = 0, c = 1, s = 0;
};

// Returns the eigenvalues and eigenvectors. The eigenvalue of greater modulus has a relative error
// of a few units in the last place, the other one an absolute error of that times the condition of
// the matrix's entries. Takes matrices near the ends of the range of doubles times a power of two,
// as squares of their entries have no double.
inline symmetric_eigen eigen_of(const metric_tensor& m) {
  constexpr double small = 0x1p-256, large = 0x1p256;
  const double size = std::max({std::abs(m.m11), std::abs(m.m12), std::abs(m.m22)});
  if ((size > 0 && size < small) || (size > large && std::isfinite(size))) {
    const int exponent = std::ilogb(size);
    symmetric_eigen e = eigen_of(times_power_of_two(m, -exponent));
    e.first = std::scalbn(e.first, exponent);
    e.second = std::scalbn(e.second, exponent);
    return e;
  }
  const double half = (m.m11 - m.m22) / 2, mean = (m.m11 + m.m22) / 2;
  const double radius = std::sqrt(half * half + m.m12 * m.m12);
  const double product = m.m12 * m.m12;
  // Adds the rounding error of the product, so that a thin tensor keeps its weak eigenvalue.
  const double determinant = std::fma(m.m11, m.m22, -product) + std::fma(-m.m12, m.m12, product);
  symmetric_eigen e;
  const double strong = mean >= 0 ? mean + radius : mean - radius;
  const double weak = strong != 0 ? determinant / strong : 0;
  e.first = mean >= 0 ? strong : weak;
  e.second = mean >= 0 ? weak : strong;
  double c = half >= 0 ? half + radius : m.m12, s = half >= 0 ? m.m12 : radius - half;
  const double length = std::sqrt(c * c + s * s);
  if (length > 0) {
    e.c = c / length;
    e.s = s / length;
  }
  return e;
}

// Returns the matrix with these eigenvalues and the eigenvectors of `e`.
inline metric_tensor with_eigenvalues(const symmetric_eigen& e, double first, double second) {
  return {first * (e.c * e.c) + second * (e.s * e.s), (first - second) * (e.c * e.s),
          first * (e.s * e.s) + second * (e.c * e.c)};
}

}  // namespace asterism::internal
