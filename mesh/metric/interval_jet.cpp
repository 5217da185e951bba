// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/interval_jet.hpp"

#include <algorithm>
#include <cstdlib>

#include "asterism/core/rounded_quotient.hpp"
#include "asterism/mesh/metric/interval_functions.hpp"

namespace asterism::internal {
namespace {

// Returns f(a) from f's value and derivative at a.
interval_jet chained(const rounded_interval& value, const rounded_interval& slope,
                     const interval_jet& a) {
  return {value, slope * a.x, slope * a.y};
}

interval_jet hull_of(const interval_jet& a, const interval_jet& b, const rounded_interval& value) {
  return {value, hull(a.x, b.x), hull(a.y, b.y)};
}

}  // namespace

interval_jet operator+(const interval_jet& a, const interval_jet& b) {
  return {a.value + b.value, a.x + b.x, a.y + b.y};
}

interval_jet operator-(const interval_jet& a) { return {-a.value, -a.x, -a.y}; }
interval_jet operator-(const interval_jet& a, const interval_jet& b) { return a + -b; }

interval_jet operator*(const interval_jet& a, const interval_jet& b) {
  return {a.value * b.value, a.value * b.x + b.value * a.x, a.value * b.y + b.value * a.y};
}

interval_jet operator/(const interval_jet& a, const interval_jet& b) {
  const rounded_interval ratio = divided(a.value, b.value);
  return {ratio, divided(a.x - ratio * b.x, b.value), divided(a.y - ratio * b.y, b.value)};
}

interval_jet square(const interval_jet& a) {
  return chained(squared(a.value), a.value + a.value, a);
}

interval_jet square_root(const interval_jet& a) {
  const rounded_interval root = root_of(a.value);
  return chained(root, divided(rounded_interval(0.5), root), a);
}

interval_jet exponential(const interval_jet& a) {
  const rounded_interval e = exponential_of(a.value);
  return chained(e, e, a);
}

interval_jet natural_logarithm(const interval_jet& a) {
  return chained(logarithm_of(a.value), divided(rounded_interval(1), a.value), a);
}

interval_jet sine(const interval_jet& a) {
  return chained(sine_of(a.value), cosine_of(a.value), a);
}

interval_jet cosine(const interval_jet& a) {
  return chained(cosine_of(a.value), -sine_of(a.value), a);
}

interval_jet hyperbolic_tangent(const interval_jet& a) {
  const rounded_interval t = hyperbolic_tangent_of(a.value);
  return chained(t, rounded_interval(1) - squared(t), a);
}

interval_jet arc_tangent(const interval_jet& a) {
  return chained(arc_tangent_of(a.value),
                 divided(rounded_interval(1), rounded_interval(1) + squared(a.value)), a);
}

interval_jet absolute(const interval_jet& a) {
  if (a.value.inf() >= 0) return a;
  if (a.value.sup() <= 0) return -a;
  return chained({0, std::max(-a.value.inf(), a.value.sup())}, {-1, 1}, a);
}

interval_jet lesser(const interval_jet& a, const interval_jet& b) {
  if (a.value.sup() <= b.value.inf()) return a;
  if (b.value.sup() <= a.value.inf()) return b;
  return hull_of(a, b,
                 {std::min(a.value.inf(), b.value.inf()), std::min(a.value.sup(), b.value.sup())});
}

interval_jet greater(const interval_jet& a, const interval_jet& b) { return -lesser(-a, -b); }

interval_jet whole_power(const interval_jet& a, int n) {
  if (n < 0) return interval_jet(1) / whole_power(a, -n);
  if (n == 0) return {1};
  const interval_jet half = whole_power(a, n / 2), even = square(half);
  return n % 2 == 0 ? even : even * a;
}

interval_jet either(const interval_jet& a, const interval_jet& b) {
  const auto is_constant = [](const interval_jet& f) {
    return f.value.inf() == f.value.sup() && f.x.inf() == 0 && f.x.sup() == 0 && f.y.inf() == 0 &&
           f.y.sup() == 0;
  };
  if (is_constant(a) && is_constant(b) && a.value.inf() == b.value.inf()) return a;
  return {hull(a.value, b.value), everything(), everything()};
}

plane_jet coordinates_over(const rounded_interval& x, const rounded_interval& y) {
  return {{x, 1, 0}, {y, 0, 1}};
}

}  // namespace asterism::internal
