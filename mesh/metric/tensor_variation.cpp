// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/tensor_variation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "asterism/core/elementary.hpp"
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/metric/interval_functions.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal {
namespace {

struct interval_tensor {
  rounded_interval m11, m12, m22;

  friend interval_tensor operator+(const interval_tensor& a, const interval_tensor& b) {
    return {a.m11 + b.m11, a.m12 + b.m12, a.m22 + b.m22};
  }
  friend interval_tensor operator*(const rounded_interval& k, const interval_tensor& a) {
    return {k * a.m11, k * a.m12, k * a.m22};
  }
};

interval_tensor values(const tensor_jet& t) { return {t.m11.value, t.m12.value, t.m22.value}; }
interval_tensor along_x(const tensor_jet& t) { return {t.m11.x, t.m12.x, t.m22.x}; }
interval_tensor along_y(const tensor_jet& t) { return {t.m11.y, t.m12.y, t.m22.y}; }

rounded_interval product_of(const interval_tensor& m, const point& a, const point& b) {
  return rounded_interval(a.x) * (m.m11 * rounded_interval(b.x) + m.m12 * rounded_interval(b.y)) +
         rounded_interval(a.y) * (m.m12 * rounded_interval(b.x) + m.m22 * rounded_interval(b.y));
}

// Returns a tensor in the coordinates whose axes are the two displacements.
interval_tensor in_frame(const interval_tensor& m, const unit_displacements& frame) {
  return {product_of(m, frame.first, frame.first), product_of(m, frame.first, frame.second),
          product_of(m, frame.second, frame.second)};
}

// Returns (m11 + m22) / 2 and the half of the difference of the eigenvalues.
struct mean_and_radius {
  rounded_interval mean, radius;
};
mean_and_radius spectrum(const interval_tensor& m) {
  const rounded_interval half = 0.5;
  return {half * (m.m11 + m.m22), root_of(squared(half * (m.m11 - m.m22)) + squared(m.m12))};
}

// Returns an upper bound of the greatest modulus of an eigenvalue.
double norm_above(const interval_tensor& m) {
  const mean_and_radius s = spectrum(m);
  const double mean = std::max(-s.mean.inf(), s.mean.sup());
  const double norm = rounded_sum(mean, s.radius.sup());
  return norm >= 0 ? norm : infinity;  // a NaN promises nothing
}

const std::array<point, variation_directions>& directions() {
  static const std::array<point, variation_directions> all = [] {
    const floating_point_scope scope(rounding::nearest);
    std::array<point, variation_directions> made{};
    for (std::size_t k = 0; k < made.size(); ++k) {
      const double t = (static_cast<double>(k) + 0.5) * (std::numbers::pi / variation_directions);
      made[k] = {elementary::cos(t), elementary::sin(t)};
    }
    return made;
  }();
  return all;
}

// Returns an upper bound of the greatest norm of v1 C1 + v2 C2 for unit vectors v: a norm is
// convex, so that it is greatest at a vertex of a polygon around the circle.
double greatest_norm(const interval_tensor& first, const interval_tensor& second) {
  double greatest = 0;
  for (const point& v : directions())
    greatest = std::max(greatest,
                        norm_above(rounded_interval(v.x) * first + rounded_interval(v.y) * second));
  return rounded_product(greatest, direction_slack);
}

std::optional<unit_displacements> frame_of(const tensor_jet& middle) {
  const auto of = [](const interval_jet& j) { return (j.value.inf() + j.value.sup()) / 2; };
  const metric_tensor m{of(middle.m11), of(middle.m12), of(middle.m22)};
  const bool is_metric = m.m11 > 0 && m.m22 > 0 && m.m11 * m.m22 > m.m12 * m.m12 &&
                         std::isfinite(m.m11) && std::isfinite(m.m22);
  if (!is_metric) return std::nullopt;
  const floating_point_scope scope(rounding::nearest);
  return unit_circle(m);
}

// Returns half of the greatest norm over the 3/2-th power of the least eigenvalue of the tensor,
// which is near the identity; infinite where it may not be positive.
double quotient_above(double norm, const interval_tensor& near_identity) {
  const mean_and_radius s = spectrum(near_identity);
  const rounded_interval least = s.mean - s.radius;
  if (!(least.inf() > 0)) return infinity;
  const rounded_interval low = least.inf();
  return divided(rounded_interval(norm), rounded_interval(2) * low * root_of(low)).sup();
}

}  // namespace

variation_of_part bound_variation_of(const small_part& part, const tensor_jet& over,
                                     const tensor_jet& in_middle) {
  const auto frame = frame_of(in_middle);
  if (!frame) return {infinity, 0};
  const auto derivative = [&](const tensor_jet& t, const point& u) {
    return in_frame(rounded_interval(u.x) * along_x(t) + rounded_interval(u.y) * along_y(t),
                    *frame);
  };
  const interval_tensor middle = in_frame(values(in_middle), *frame);
  // Encloses the tensor over the part in two ways: as the tensor in the middle plus derivatives
  // times distances, and directly, which is tighter for a long part along which the tensor hardly
  // changes.
  const rounded_interval dx(-part.reach_x, part.reach_x), dy(-part.reach_y, part.reach_y);
  const interval_tensor anywhere =
      middle + dx * in_frame(along_x(over), *frame) + dy * in_frame(along_y(over), *frame);
  const double norm =
      greatest_norm(derivative(over, frame->first), derivative(over, frame->second));
  const double here =
      greatest_norm(derivative(in_middle, frame->first), derivative(in_middle, frame->second));
  const interval_tensor as_enclosed = in_frame(values(over), *frame);
  variation_of_part found{
      std::min(quotient_above(norm, anywhere), quotient_above(norm, as_enclosed)),
      quotient_above(here, middle) / direction_slack};
  if (!(found.above >= 0)) found.above = infinity;
  if (!(found.in_middle < infinity)) found.in_middle = 0;
  return found;
}

double bound_variation_of(const layer_enclosure& h) {
  const rounded_interval half = 0.5;
  const interval_tensor across{h.across_by_normal, -(half * (h.across * h.turn_by_normal)),
                               divided(h.across * h.along_by_normal, h.along)};
  const interval_tensor along{divided(h.along * h.across_by_tangent, h.across),
                              -(half * (h.along * h.turn_by_tangent)), h.along_by_tangent};
  const double norm = greatest_norm(across, along);
  return norm >= 0 ? norm : infinity;
}

}  // namespace asterism::internal
