// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"

#include <cmath>

#include "asterism/mesh/support/double_double.hpp"

namespace asterism::internal {

// Computes m11 - m12^2 / m22 without cancellation: m12 = q m22 + r exactly, so that m12^2 / m22 = q
// m12 + q r + r^2 / m22, the last below 2^-106 of the first; the part that cancels, m11 - q m12, is
// rounded once.
double least_across(double m11, double m12, double m22) {
  const double q = m12 / m22, r = std::fma(-q, m22, m12);
  return std::fma(-q, m12, m11) - q * r;
}

double root_of_determinant(const metric_tensor& m) {
  return std::sqrt(m.m11) * std::sqrt(least_across(m.m22, m.m12, m.m11));
}

double squared_length_of_thin(const metric_tensor& m, double dx, double dy) {
  const double_double x(dx), y(dy), mixed = double_double(m.m12) * (x * y);
  return static_cast<double>(double_double(m.m11) * (x * x) + double_double(m.m22) * (y * y) +
                             (mixed + mixed));
}

round_coordinates::round_coordinates(const point& origin, const metric_tensor& round)
    : origin_(origin),
      f11_(std::sqrt(round.m11)),
      f12_(round.m12 / f11_),
      f22_(std::sqrt(least_across(round.m22, round.m12, round.m11))),
      g11_(1 / f11_),
      g12_(-f12_ / (f11_ * f22_)),
      g22_(1 / f22_) {}

site round_coordinates::inward(const site& s) const {
  const double dx = s.position.x - origin_.x, dy = s.position.y - origin_.y;
  return {{f11_ * dx + f12_ * dy, f22_ * dy}, inward(s.metric)};
}

point round_coordinates::outward(const point& u) const {
  return {g11_ * u.x + g12_ * u.y, g22_ * u.y};
}

// Returns F^-T M F^-1.
metric_tensor round_coordinates::inward(const metric_tensor& m) const {
  const double_double m11(m.m11), m12(m.m12), m22(m.m22), g11(g11_), g12(g12_), g22(g22_);
  const double_double x = m11 * g12 + m12 * g22, y = m12 * g12 + m22 * g22;
  return {static_cast<double>(g11 * (m11 * g11)), static_cast<double>(g11 * x),
          static_cast<double>(g12 * x + g22 * y)};
}

}  // namespace asterism::internal
