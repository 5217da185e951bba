// SPDX-License-Identifier: MIT
//
// Implements the first tier: one evaluation in plain doubles and one error bound from magnitudes.
// It neither reads nor changes the floating-point environment: the bounds hold in every rounding
// mode and with flush-to-zero or denormals-are-zero set.
//
// Bound. In any rounding mode an operation has a relative error of at most eps = 2^-52 and, where
// it underflows or a subnormal operand is read as zero, an absolute one of at most 2^-1022. A value
// is a sum of monomials, each carrying at most `depth` factors 1 + delta, |delta| <= eps; with S a
// computed bound on the sum of their absolute values the error is at most (depth + slack) eps S,
// where the slack of 8 covers the rounding of S itself (at most 13 operations deep), of the bound
// made from it and the second order. The depths are recomputed by a test that runs the same
// formulas on a counting type; code in two lanes evaluates these formulas for two sites at once.
// Absolute errors: every operand is kept below 2^200 (differences and metrics), so the factor of an
// underflow in a formula of degree 5 stays below 2^(4*201), and the errors of a few dozen
// underflows below 2^-200: values that are not above 2^-200 + bound are undecided. The range is
// checked by comparison, not by looking for infinities: rounding towards zero makes none.
// Derivation: docs/math/tiers.md.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "asterism/core/floating_point_environment.hpp"  // refuses -ffast-math
#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/two_doubles.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/wedge.hpp"

namespace asterism::internal::semi_static {

using internal::between;

inline constexpr double eps = 0x1p-52;
inline constexpr double slack = 8;
inline constexpr double smallest_decided = 0x1p-200;
inline constexpr double largest_operand = 0x1p200;

// Numbers of factors 1 + delta on any monomial of each value.
inline constexpr int orientation_depth = 4;
inline constexpr int compare_distance_depth = 7;
inline constexpr int wedge_depth = 6;
inline constexpr int steepness_depth = 8;
inline constexpr int opposite_angles_depth = 12;
inline constexpr int in_circle_depth = 13;

constexpr double bound_factor(int depth) { return (depth + slack) * eps; }

// Returns the sign of a value that is certainly not zero.
inline sign sign_of_nonzero(double value) {
  return static_cast<sign>((std::bit_cast<std::int64_t>(value) >> 63) | 1);
}

// Returns the sign of a value with an error of at most `bound`. A NaN in either is undecided.
inline uncertain_sign decide(double value, double bound) {
  return std::abs(value) > bound ? uncertain_sign(sign_of_nonzero(value)) : uncertain_sign();
}
inline uncertain_sign decide(double value, double magnitude, double factor) {
  return decide(value, factor * magnitude + smallest_decided);
}

// Bounds |ax by| <= (ax^2 + by^2) / 2: half the sum of squares serves as the magnitude and as the
// test of the range, which finds an overflow even where rounding towards zero gives the largest
// double.
inline uncertain_sign orientation(const point& p, const point& q, const point& r) {
  const two_doubles from_p = pair(p.x, p.y);
  const two_doubles a = pair(q.x, q.y) - from_p, b = pair(r.x, r.y) - from_p;
  const two_doubles products = a * exchanged(b);
  const double squares = sum(a * a + b * b);
  if (!(squares <= largest_operand * largest_operand)) return {};
  return decide(difference(products), squares, 0.5 * bound_factor(orientation_depth));
}

// Two metrics, one in each lane.
struct two_metrics {
  two_doubles m11, m12, m22;
};
inline two_metrics together(const metric_tensor& a, const metric_tensor& b) {
  return {pair(a.m11, b.m11), pair(a.m12, b.m12), pair(a.m22, b.m22)};
}
inline two_displacements together(const displacement<double>& a, const displacement<double>& b) {
  return {pair(a.x, b.x), pair(a.y, b.y)};
}
inline two_displacements both(const displacement<double>& u) {
  return {asterism::internal::both(u.x), asterism::internal::both(u.y)};
}
inline two_displacements between(const point& a, const point& b, const point& q) {
  return {asterism::internal::both(q.x) - pair(a.x, b.x),
          asterism::internal::both(q.y) - pair(a.y, b.y)};
}

// Returns u^T M u in both lanes, and an upper bound on the sum of the absolute monomials: 2 |m12 ux
// uy| <= m11 ux^2 + m22 uy^2 for M positive definite.
struct two_lengths {
  two_doubles value, half_magnitude;
  two_doubles square;  // ux^2 + uy^2
};
inline two_lengths squared_lengths(const two_metrics& m, const two_displacements& u) {
  const two_doubles xx = u.x * u.x, yy = u.y * u.y, xy = m.m12 * (u.x * u.y);
  const two_doubles unmixed = m.m11 * xx + m.m22 * yy;
  return {unmixed + (xy + xy), unmixed, xx + yy};
}

// Tests that operands are in range: by sums, so that one comparison serves several. Squares of
// displacements may take the place of displacements.
inline two_doubles extent(const two_metrics& m) { return m.m11 + m.m22; }
inline two_doubles extent(const two_displacements& u) { return absolute(u.x) + absolute(u.y); }
inline bool in_range(two_doubles extents) {
  return both_less(extents, asterism::internal::both(largest_operand));
}

inline uncertain_sign compare_distance(const site& v, const site& w, const point& q) {
  const two_displacements u = between(v.position, w.position, q);
  const two_metrics m = together(v.metric, w.metric);
  const two_lengths lengths = squared_lengths(m, u);
  if (!in_range(extent(m) + lengths.square)) return {};
  return decide(difference(lengths.value), sum(lengths.half_magnitude),
                2 * bound_factor(compare_distance_depth));
}

// Returns u^T M d in both lanes. |u^T M d| <= (|ux| + |uy|) (|dx| + |dy|) (m11 + m22), term by
// term, since |m12| is below the mean of m11 and m22.
inline two_doubles inner_products(const two_metrics& m, const two_displacements& u,
                                  const two_displacements& d) {
  return u.x * (m.m11 * d.x + m.m12 * d.y) + u.y * (m.m12 * d.x + m.m22 * d.y);
}

inline uncertain_bool in_wedge(const site& v, const site& w, const point& q) {
  const two_doubles x = pair(v.position.x, w.position.x), y = pair(v.position.y, w.position.y);
  const two_displacements u = {asterism::internal::both(q.x) - x,
                               asterism::internal::both(q.y) - y};
  const two_displacements d = {exchanged(x) - x, exchanged(y) - y};  // w - v and v - w
  const two_metrics m = together(v.metric, w.metric);
  const two_doubles of_m = extent(m), of_u = extent(u), of_d = extent(d);
  if (!in_range(of_m + (of_u + of_d))) return {};
  const two_doubles value = inner_products(m, u, d);
  const two_doubles bound =
      of_u * (of_d * of_m) * asterism::internal::both(bound_factor(wedge_depth)) +
      asterism::internal::both(smallest_decided);
  if (both_less(bound, absolute(value))) return sign_bits(value) == 0;
  // Returns false if one of the lanes is certainly not positive.
  const bool outside = (value[0] < -bound[0]) | (value[1] < -bound[1]);
  return outside ? uncertain_bool(false) : uncertain_bool();
}

// True if the segment from `near` to the point at displacement u certainly does not cross the
// bisector twice. Requires that the point is nearer to `near` than to `far`. Three sufficient
// conditions (predicates/domination.hpp): A + C > 0, H < 0, A + H > 0. `seen_near` is |u|^2 in the
// metric of `near`, and `half_magnitude` half the sum of its absolute monomials.
inline bool crossed_less_than_twice(double seen_near, double half_magnitude,
                                    const metric_tensor& far, const displacement<double>& u,
                                    const displacement<double>& d) {
  constexpr double factor = bound_factor(steepness_depth);
  const two_lengths by_far = squared_lengths(together(far, far), together(u, d));
  const double a = seen_near - by_far.value[0];
  if (decide(a + by_far.value[1], half_magnitude + sum(by_far.half_magnitude), 2 * factor)
          .certainly(sign::positive))
    return true;
  const double h = dot(u, apply(far, d));
  const double mixed =
      (std::abs(u.x) + std::abs(u.y)) * ((std::abs(d.x) + std::abs(d.y)) * (far.m11 + far.m22));
  const double lengths = 2 * (half_magnitude + by_far.half_magnitude[0]);
  return decide(h, mixed, bound_factor(wedge_depth)).certainly(sign::negative) ||
         decide(a + h, lengths + mixed, factor).certainly(sign::positive);
}

// Decides domination where the nearer site's segment meets the bisector less than twice: then that
// site dominates. Each condition excludes tangencies, where two meetings would count as one.
inline uncertain_sign dominates(const site& v, const site& w, const point& p) {
  const two_displacements u = between(v.position, w.position, p);
  const displacement<double> d = between(v.position, w.position);
  const two_metrics m = together(v.metric, w.metric);
  const two_lengths lengths = squared_lengths(m, u);
  if (!in_range((extent(m) + lengths.square) + extent(both(d)))) return {};
  const double value = difference(lengths.value);
  const uncertain_sign nearer =
      decide(value, sum(lengths.half_magnitude), 2 * bound_factor(compare_distance_depth));
  if (!nearer.certain()) return {};
  // Selects by address: the nearer site is unpredictable, and a branch would be mispredicted.
  const bool v_nearer = nearer.value() == sign::negative;
  const std::array<const site*, 2> sites = {&v, &w};
  const site &near = *sites[v_nearer ? 0 : 1], &far = *sites[v_nearer ? 1 : 0];
  const bool decided = crossed_less_than_twice(
      v_nearer ? lengths.value[0] : lengths.value[1],
      v_nearer ? lengths.half_magnitude[0] : lengths.half_magnitude[1], far.metric,
      between(near.position, p), between(near.position, far.position));
  return decided ? uncertain_sign(-nearer.value()) : uncertain_sign();
}

// Tests m11 > 0 exactly; the determinant has two monomials.
inline uncertain_bool is_positive_definite(const metric_tensor& m) {
  if (!(m.m11 > smallest_decided)) return {};
  if (!(m.m11 + std::abs(m.m12) + std::abs(m.m22) <= largest_operand)) return {};
  const double diagonal = m.m11 * m.m22, mixed = m.m12 * m.m12;
  return is_positive(decide(diagonal - mixed, std::abs(diagonal) + mixed, bound_factor(2)));
}

// Values u^T M u and cross products, each with half the sum of its absolute monomials, or a bound
// on it.
struct circle_term {
  double value, half_magnitude;
};
inline circle_term circle_length(const metric_tensor& m, const displacement<double>& u) {
  const double unmixed = m.m11 * (u.x * u.x) + m.m22 * (u.y * u.y), mixed = m.m12 * (u.x * u.y);
  return {unmixed + (mixed + mixed), unmixed};
}
inline circle_term twice_area(const displacement<double>& a, const displacement<double>& b) {
  const double left = a.x * b.y, right = a.y * b.x;
  return {left - right, 0.5 * (std::abs(left) + std::abs(right))};
}

inline uncertain_sign in_circle(const metric_tensor& m, const point& a, const point& b,
                                const point& c, const point& p) {
  const auto u = between(p, a), v = between(p, b), w = between(p, c);
  const double extents = ((std::abs(u.x) + std::abs(u.y)) + (std::abs(v.x) + std::abs(v.y))) +
                         ((std::abs(w.x) + std::abs(w.y)) + (m.m11 + m.m22));
  if (!(extents <= largest_operand)) return {};
  const circle_term of_u = circle_length(m, u), of_v = circle_length(m, v),
                    of_w = circle_length(m, w), vw = twice_area(v, w), wu = twice_area(w, u),
                    uv = twice_area(u, v);
  const double value = (of_u.value * vw.value + of_v.value * wu.value) + of_w.value * uv.value;
  const double quarter =
      (of_u.half_magnitude * vw.half_magnitude + of_v.half_magnitude * wu.half_magnitude) +
      of_w.half_magnitude * uv.half_magnitude;
  return decide(value, quarter, 4 * bound_factor(in_circle_depth));
}

// Decides INSERTIONTEST of four equal metrics, x and y strictly on different sides of the line vw.
// Lanes: x and y.
inline uncertain_bool insertion_test_equal_metrics(const site& v, const site& w, const site& x,
                                                   const site& y) {
  const two_displacements ends = {pair(x.position.x, y.position.x),
                                  pair(x.position.y, y.position.y)};
  const two_displacements d = both(between(v.position, w.position)),
                          from_v = ends - both(displacement<double>{v.position.x, v.position.y}),
                          from_w = ends - both(displacement<double>{w.position.x, w.position.y});
  const two_metrics m = together(v.metric, v.metric);
  const two_doubles of_m = extent(m), of_from_v = extent(from_v), of_from_w = extent(from_w);
  if (!in_range((of_m + extent(d)) + (of_from_v + of_from_w))) return {};
  const two_doubles left = d.x * from_v.y, right = d.y * from_v.x;
  const two_doubles side = left - right, side_magnitude = absolute(left) + absolute(right);
  const two_doubles side_bound =
      asterism::internal::both(bound_factor(orientation_depth)) * side_magnitude +
      asterism::internal::both(smallest_decided);
  const two_doubles side_size = absolute(side);
  if (!both_less(side_bound, side_size)) return {};
  if (sign_bits(side) == 0 || sign_bits(side) == 3) return true;
  const two_doubles slope = inner_products(m, from_v, from_w);
  const two_doubles slope_magnitude = of_from_v * (of_from_w * of_m);
  const uncertain_sign outside =
      decide(sum(slope * exchanged(side_size)), sum(slope_magnitude * exchanged(side_magnitude)),
             bound_factor(opposite_angles_depth));
  return is_positive(outside);
}

}  // namespace asterism::internal::semi_static
