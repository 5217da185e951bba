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
  if (!(std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y) <= largest_operand))
    return {};
  return decide(left - right, std::abs(left) + std::abs(right), bound_factor(orientation_depth));
}

// An upper bound on the sum of the absolute monomials of u^T M u, M positive definite:
// 2 |m12 ux uy| <= m11 ux^2 + m22 uy^2.
inline double length_magnitude(const metric_tensor& m, const displacement<double>& u) {
  return 2 * (m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y));
}

inline bool harmless(const metric_tensor& m) { return m.m11 + m.m22 <= largest_operand; }
inline bool harmless(const displacement<double>& u) {
  return u.x * u.x + u.y * u.y <= largest_operand * largest_operand;
}

inline uncertain_sign compare_distance(const site& v, const site& w, const point& q) {
  const auto from_v = between(v.position, q), from_w = between(w.position, q);
  if (!(harmless(v.metric) && harmless(w.metric) && harmless(from_v) && harmless(from_w)))
    return {};
  return decide(squared_length(v.metric, from_v) - squared_length(w.metric, from_w),
                length_magnitude(v.metric, from_v) + length_magnitude(w.metric, from_w),
                bound_factor(compare_distance_depth));
}

// |u^T M d| <= (|ux| + |uy|) (|dx| + |dy|) (m11 + m22), term by term, since |m12| is below the mean
// of m11 and m22.
inline uncertain_sign wedge(const metric_tensor& m, const displacement<double>& u,
                            const displacement<double>& d) {
  const double magnitude =
      (std::abs(u.x) + std::abs(u.y)) * ((std::abs(d.x) + std::abs(d.y)) * (m.m11 + m.m22));
  return decide(dot(u, apply(m, d)), magnitude, bound_factor(wedge_depth));
}

inline uncertain_bool in_wedge(const site& v, const site& w, const point& q) {
  const auto d = between(v.position, w.position);
  const auto from_v = between(v.position, q), from_w = between(w.position, q);
  if (!(harmless(v.metric) && harmless(w.metric) && harmless(from_v) && harmless(from_w) &&
        harmless(d)))
    return {};
  return is_positive(wedge(v.metric, from_v, d)) & is_positive(wedge(w.metric, from_w, -d));
}

// Decides the usual case: the nearer site dominates because its view cannot be crossed twice
// (A + C >= 0, predicates/domination.hpp). Anything else is undecided.
inline uncertain_sign dominates(const site& v, const site& w, const point& p) {
  const uncertain_sign nearer = compare_distance(v, w, p);
  if (!nearer.certain()) return {};
  const bool first = nearer.value() == sign::negative;
  const site &near = first ? v : w, &far = first ? w : v;
  const auto u = between(near.position, p), d = between(near.position, far.position);
  if (!harmless(d)) return {};
  const double seen_near = squared_length(near.metric, u), seen_far = squared_length(far.metric, u),
               apart = squared_length(far.metric, d);
  const double magnitude = length_magnitude(near.metric, u) + length_magnitude(far.metric, u) +
                           length_magnitude(far.metric, d);
  const uncertain_sign room =
      decide((seen_near - seen_far) + apart, magnitude, bound_factor(steepness_depth));
  return room.certainly(sign::positive) ? uncertain_sign(-nearer.value()) : uncertain_sign();
}

inline uncertain_sign in_circle(const metric_tensor& m, const point& v, const point& w,
                                const point& x, const point& y) {
  const auto a = between(y, v), b = between(y, w), c = between(y, x);
  if (!(harmless(m) && harmless(a) && harmless(b) && harmless(c))) return {};
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
