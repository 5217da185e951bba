// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/simultaneous_reduction.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {
namespace {

// Returns the root of x^2 + y^2, computed directly unless a square may leave the range of doubles.
double root_of_squares(double x, double y) {
  const double squares = x * x + y * y;
  const bool is_ordinary = squares > 0x1p-900 && squares < 0x1p1000;
  return is_ordinary ? std::sqrt(squares) : elementary::hypot(x, y);
}

}  // namespace

simultaneous_reduction reduce(const metric_tensor& a, const metric_tensor& b) {
  simultaneous_reduction r{};
  r.f11 = std::sqrt(a.m11);
  r.f12 = a.m12 / r.f11;
  r.f22 = std::sqrt(std::max(std::fma(a.m11, a.m22, -a.m12 * a.m12), 0.0)) / r.f11;
  // Forms C = G^T B G with G = F^-1 = [1/f11, -f12/(f11 f22); 0, 1/f22].
  const double g11 = 1 / r.f11, g12 = -r.f12 / (r.f11 * r.f22), g22 = 1 / r.f22;
  const double c11 = g11 * g11 * b.m11, c12 = g11 * (g12 * b.m11 + g22 * b.m12),
               c22 = g12 * g12 * b.m11 + 2 * g12 * g22 * b.m12 + g22 * g22 * b.m22;
  const double half = (c11 - c22) / 2, radius = root_of_squares(half, c12);
  r.high = (c11 + c22) / 2 + radius;
  const double of_b = std::max(std::fma(b.m11, b.m22, -b.m12 * b.m12), 0.0),
               of_a = std::max(std::fma(a.m11, a.m22, -a.m12 * a.m12), 0.0);
  const double determinant = of_b / of_a;
  r.low = std::isinf(determinant) ? of_b / r.high / of_a : determinant / r.high;
  double x = half >= 0 ? half + radius : c12, y = half >= 0 ? c12 : radius - half;
  const double length = root_of_squares(x, y);
  r.c = length > 0 ? x / length : 1;
  r.s = length > 0 ? y / length : 0;
  return r;
}

metric_tensor restore(const simultaneous_reduction& r, double high, double low) {
  const double d11 = high * r.c * r.c + low * r.s * r.s, d12 = (high - low) * r.c * r.s,
               d22 = high * r.s * r.s + low * r.c * r.c;
  return {r.f11 * r.f11 * d11, r.f11 * (r.f12 * d11 + r.f22 * d12),
          r.f12 * r.f12 * d11 + 2 * r.f12 * r.f22 * d12 + r.f22 * r.f22 * d22};
}

metric_tensor simultaneous_intersection(const metric_tensor& a, const metric_tensor& b) {
  const simultaneous_reduction r = reduce(a, b);
  if (r.high <= 1) return a;
  if (r.low >= 1) return b;
  return restore(r, r.high, 1);
}

}  // namespace asterism::internal
