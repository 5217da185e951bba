// SPDX-License-Identifier: MIT
//
// The first tier: one evaluation in plain doubles and one error bound from magnitudes. It neither
// reads nor changes the floating-point environment: the bounds hold in every rounding mode and with
// flush-to-zero or denormals-are-zero set.
//
// Bound. In any rounding mode an operation has a relative error of at most eps = 2^-52 and, where
// it underflows or a subnormal operand is read as zero, an absolute one of at most 2^-1022. A value
// is a sum of monomials, each carrying at most `depth` factors 1 + delta, |delta| <= eps; with S a
// computed bound on the sum of their absolute values the error is at most (depth + slack) eps S,
// where the slack of 8 covers the rounding of S itself (at most 7 operations deep) and the second
// order. The depths are recomputed by a test that runs the same formulas on a counting type.
// Absolute errors: every operand is kept below 2^200 (differences and metrics), so what multiplies
// an underflow of a degree 5 formula stays below 2^(4*201), and a few dozen of those below 2^-200:
// values that are not above 2^-200 + bound are undecided. Derivation: docs/math/tiers.md.
#pragma once

#ifdef __FAST_MATH__
#error "asterism: exact predicates cannot be compiled with -ffast-math"
#endif

#include <cmath>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/wedge.hpp"

namespace asterism::semi_static {

inline constexpr double eps = 0x1p-52;
inline constexpr double slack = 8;
inline constexpr double smallest_decided = 0x1p-200;
inline constexpr double largest_operand = 0x1p200;

// Factors 1 + delta on any monomial of each value.
inline constexpr int orientation_depth = 4;
inline constexpr int compare_distance_depth = 7;
inline constexpr int wedge_depth = 6;
inline constexpr int steepness_depth = 8;
inline constexpr int in_circle_depth = 13;

constexpr double bound_factor(int depth) { return (depth + slack) * eps; }

// The sign of a value with an error of at most factor * magnitude + smallest_decided. A NaN in
// either is undecided.
inline uncertain_sign decide(double value, double magnitude, double factor) {
  const double bound = factor * magnitude + smallest_decided;
  if (value > bound) return sign::positive;
  if (value < -bound) return sign::negative;
  return {};
}

inline uncertain_sign orientation(const point& p, const point& q, const point& r) {
  const auto a = between(p, q), b = between(p, r);
  const double left = a.x * b.y, right = a.y * b.x;
  if (!(std::abs(a.x) + std::abs(a.y) + (std::abs(b.x) + std::abs(b.y)) <= largest_operand))
    return {};
  return decide(left - right, std::abs(left) + std::abs(right), bound_factor(orientation_depth));
}

// An upper bound on the sum of the absolute monomials of u^T M u, M positive definite:
// 2 |m12 ux uy| <= m11 ux^2 + m22 uy^2.
inline double length_magnitude(const metric_tensor& m, const displacement<double>& u) {
  return 2 * (m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y));
}

// Operands in range: sums, so that one comparison serves several.
inline double extent(const metric_tensor& m) { return m.m11 + m.m22; }
inline double extent(const displacement<double>& u) { return std::abs(u.x) + std::abs(u.y); }
inline bool in_range(double sum_of_extents) { return sum_of_extents <= largest_operand; }

inline uncertain_sign compare_distance(const site& v, const site& w, const point& q) {
  const auto from_v = between(v.position, q), from_w = between(w.position, q);
  if (!in_range((extent(v.metric) + extent(w.metric)) + (extent(from_v) + extent(from_w))))
    return {};
  return decide(squared_length(v.metric, from_v) - squared_length(w.metric, from_w),
                length_magnitude(v.metric, from_v) + length_magnitude(w.metric, from_w),
                bound_factor(compare_distance_depth));
}

// |u^T M d| <= (|ux| + |uy|) (|dx| + |dy|) (m11 + m22), term by term, since |m12| is below the mean
// of m11 and m22.
inline double inner_magnitude(const metric_tensor& m, const displacement<double>& u,
                              const displacement<double>& d) {
  return extent(u) * (extent(d) * extent(m));
}

inline uncertain_bool in_wedge(const site& v, const site& w, const point& q) {
  const auto d = between(v.position, w.position);
  const auto from_v = between(v.position, q), from_w = between(w.position, q);
  if (!in_range((extent(v.metric) + extent(w.metric)) +
                ((extent(from_v) + extent(from_w)) + extent(d))))
    return {};
  constexpr double factor = bound_factor(wedge_depth);
  const double seen_from_v = dot(from_v, apply(v.metric, d)),
               seen_from_w = -dot(from_w, apply(w.metric, d));
  return is_positive(decide(seen_from_v, inner_magnitude(v.metric, from_v, d), factor)) &
         is_positive(decide(seen_from_w, inner_magnitude(w.metric, from_w, d), factor));
}

// Does the view of `near` to a point at u from it, known to be nearer to it than to `far`,
// certainly not cross the bisector twice? Three sufficient conditions (predicates/domination.hpp):
// A + C > 0, H < 0, A + H > 0.
inline bool crossed_less_than_twice(const site& near, const site& far,
                                    const displacement<double>& u, const displacement<double>& d) {
  constexpr double factor = bound_factor(steepness_depth);
  const double a = squared_length(near.metric, u) - squared_length(far.metric, u);
  const double lengths = length_magnitude(near.metric, u) + length_magnitude(far.metric, u);
  if (decide(a + squared_length(far.metric, d), lengths + length_magnitude(far.metric, d), factor)
          .certainly(sign::positive))
    return true;
  const double h = dot(u, apply(far.metric, d)), mixed = inner_magnitude(far.metric, u, d);
  return decide(h, mixed, bound_factor(wedge_depth)).certainly(sign::negative) ||
         decide(a + h, lengths + mixed, factor).certainly(sign::positive);
}

// Decides where the nearer site's view is crossed less than twice; it dominates then, unless a
// tangency, which none of the conditions allows, counts one point.
inline uncertain_sign dominates(const site& v, const site& w, const point& p) {
  const auto d = between(v.position, w.position);
  const auto from_v = between(v.position, p), from_w = between(w.position, p);
  if (!in_range((extent(v.metric) + extent(w.metric)) +
                ((extent(from_v) + extent(from_w)) + extent(d))))
    return {};
  const uncertain_sign nearer =
      decide(squared_length(v.metric, from_v) - squared_length(w.metric, from_w),
             length_magnitude(v.metric, from_v) + length_magnitude(w.metric, from_w),
             bound_factor(compare_distance_depth));
  if (!nearer.certain()) return {};
  const bool decided = nearer.value() == sign::negative ? crossed_less_than_twice(v, w, from_v, d)
                                                        : crossed_less_than_twice(w, v, from_w, -d);
  return decided ? uncertain_sign(-nearer.value()) : uncertain_sign();
}

inline uncertain_sign in_circle(const metric_tensor& m, const point& v, const point& w,
                                const point& x, const point& y) {
  const auto a = between(y, v), b = between(y, w), c = between(y, x);
  if (!in_range(extent(m) + ((extent(a) + extent(b)) + extent(c)))) return {};
  const double bxcy = b.x * c.y, bycx = b.y * c.x, cxay = c.x * a.y, cyax = c.y * a.x,
               axby = a.x * b.y, aybx = a.y * b.x;
  const double value = squared_length(m, a) * (bxcy - bycx) + squared_length(m, b) * (cxay - cyax) +
                       squared_length(m, c) * (axby - aybx);
  const double magnitude = length_magnitude(m, a) * (std::abs(bxcy) + std::abs(bycx)) +
                           length_magnitude(m, b) * (std::abs(cxay) + std::abs(cyax)) +
                           length_magnitude(m, c) * (std::abs(axby) + std::abs(aybx));
  return decide(value, magnitude, bound_factor(in_circle_depth));
}

// m11 > 0 is exact as it stands; the determinant has two monomials.
inline uncertain_bool is_positive_definite(const metric_tensor& m) {
  if (!(m.m11 > smallest_decided)) return {};
  if (!(m.m11 + std::abs(m.m12) + std::abs(m.m22) <= largest_operand)) return {};
  const double diagonal = m.m11 * m.m22, mixed = m.m12 * m.m12;
  return is_positive(decide(diagonal - mixed, std::abs(diagonal) + mixed, bound_factor(2)));
}

// INSERTIONTEST of four equal metrics, x and y strictly on different sides of the line vw.
inline uncertain_bool insertion_test_equal_metrics(const site& v, const site& w, const site& x,
                                                   const site& y) {
  const uncertain_sign side_x = orientation(v.position, w.position, x.position);
  if (!side_x.certain()) return {};
  const uncertain_sign side_y = orientation(v.position, w.position, y.position);
  if (!side_y.certain()) return {};
  if (side_x.value() == side_y.value()) return true;
  const uncertain_sign inside = in_circle(v.metric, v.position, w.position, x.position, y.position);
  return inside.certain() ? uncertain_bool(inside.value() != side_x.value()) : uncertain_bool();
}

}  // namespace asterism::semi_static
