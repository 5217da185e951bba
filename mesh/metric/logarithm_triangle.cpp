// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/logarithm_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/rounded_quotient.hpp"
#include "asterism/mesh/metric/interval_functions.hpp"
#include "asterism/mesh/metric/interval_jet.hpp"
#include "asterism/mesh/numerics/metric_algebra.hpp"

namespace asterism::internal {
namespace {

// Largest number of halvings: a part halved more often has no bound. It also bounds the rounding
// errors of corners.
constexpr int most_halvings = 60;

enclosed_logarithm enclosed(const tensor_logarithm& l) { return {l.l11, l.l12, l.l22}; }

enclosed_logarithm mean_of(const enclosed_logarithm& a, const enclosed_logarithm& b) {
  const rounded_interval half = 0.5;
  return {half * (a[0] + b[0]), half * (a[1] + b[1]), half * (a[2] + b[2])};
}

double middle(const rounded_interval& a) { return (a.inf() + a.sup()) / 2; }

double change_along(const enclosed_logarithm& a, const enclosed_logarithm& b) {
  double change = 0;
  for (std::size_t k = 0; k < 3; ++k)
    change = std::max(change, std::abs(middle(a[k]) - middle(b[k])));
  return change;
}

// Computes the derivatives of the logarithm's entries, which are linear in the triangle.
[[gnu::noinline]] bool find_derivatives(logarithm_triangle& t) {
  const floating_point_scope scope(rounding::upward);
  const auto x = [&](std::size_t k) {
    return rounded_interval(t.corners[k].x) - rounded_interval(t.corners[0].x);
  };
  const auto y = [&](std::size_t k) {
    return rounded_interval(t.corners[k].y) - rounded_interval(t.corners[0].y);
  };
  const rounded_interval area = x(1) * y(2) - y(1) * x(2);
  if (!(area.sup() > 0)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const rounded_interval first = t.logarithms[1][k] - t.logarithms[0][k],
                           second = t.logarithms[2][k] - t.logarithms[0][k];
    t.by_x[k] = divided(first * y(2) - second * y(1), area);
    t.by_y[k] = divided(second * x(1) - first * x(2), area);
  }
  return true;
}

}  // namespace

// Returns the tensor whose logarithm has these entries over a part, with its derivatives:
// e^m (C I + S D), D the logarithm less m I, m half its trace, and C, S functions of |D|^2.
tensor_jet exponential_over(const enclosed_logarithm& l, const enclosed_logarithm& by_x,
                            const enclosed_logarithm& by_y) {
  const auto entry = [&](std::size_t k) { return interval_jet(l[k], by_x[k], by_y[k]); };
  const interval_jet half = 0.5, m = half * (entry(0) + entry(2)), a = half * (entry(0) - entry(2)),
                     b = entry(1), q = square(a) + square(b), scale = exponential(m);
  const even_functions of = even_functions_of({std::max(q.value.inf(), 0.0), q.value.sup()});
  const rounded_interval half_slope = rounded_interval(0.5) * of.sinhc;
  const interval_jet c(of.cosh, half_slope * q.x, half_slope * q.y),
      s(of.sinhc, of.slope * q.x, of.slope * q.y);
  return {scale * (c + s * a), scale * s * b, scale * (c - s * a)};
}

std::optional<logarithm_triangle> logarithm_triangle::make(const site& a, const site& b,
                                                           const site& c) {
  logarithm_triangle made;
  made.corners = {a.position, b.position, c.position};
  made.logarithms = {enclosed(logarithm(a.metric)), enclosed(logarithm(b.metric)),
                     enclosed(logarithm(c.metric))};
  for (const point& p : made.corners)
    made.greatest_coordinate = std::max({made.greatest_coordinate, std::abs(p.x), std::abs(p.y)});
  if (!find_derivatives(made)) return std::nullopt;
  return made;
}

variation_of_part logarithm_triangle::bounds() const {
  enclosed_logarithm over, in_middle;
  for (std::size_t k = 0; k < 3; ++k) {
    const rounded_interval &a = logarithms[0][k], &b = logarithms[1][k], &c = logarithms[2][k];
    over[k] = hull(hull(a, b), c);
    in_middle[k] = quotient(a + b + c, rounded_interval(3));
  }
  small_part shape;
  // Bounds errors in units of 2^-52 of the greatest coordinate: at most 60 for the corner after 60
  // halvings, 60 for the middle of three such corners, 3 for the sum and quotient of that, 2 for
  // the difference from it. The sum is below 2^8.
  const double slack = greatest_coordinate * 0x1p-44;
  shape.middle = {(corners[0].x + corners[1].x + corners[2].x) / 3,
                  (corners[0].y + corners[1].y + corners[2].y) / 3};
  for (const point& p : corners) {
    shape.reach_x = std::max(shape.reach_x, std::abs(p.x - shape.middle.x) + slack);
    shape.reach_y = std::max(shape.reach_y, std::abs(p.y - shape.middle.y) + slack);
  }
  return bound_variation_of(shape, exponential_over(over, by_x, by_y),
                            exponential_over(in_middle, by_x, by_y));
}

std::optional<std::array<logarithm_triangle, 2>> logarithm_triangle::halves() const {
  if (depth >= most_halvings) return std::nullopt;
  const floating_point_scope scope(rounding::upward);
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double change = change_along(logarithms[k], logarithms[(k + 1) % 3]);
    if (change > most) {
      most = change;
      widest = k;
    }
  }
  const std::size_t from = widest, to = (widest + 1) % 3;
  const point m{corners[from].x / 2 + corners[to].x / 2, corners[from].y / 2 + corners[to].y / 2};
  const enclosed_logarithm mean = mean_of(logarithms[from], logarithms[to]);
  std::array<logarithm_triangle, 2> both = {*this, *this};
  both[0].corners[to] = both[1].corners[from] = m;
  both[0].logarithms[to] = both[1].logarithms[from] = mean;
  both[0].depth = both[1].depth = depth + 1;
  return both;
}

}  // namespace asterism::internal
