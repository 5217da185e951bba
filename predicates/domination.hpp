// SPDX-License-Identifier: MIT
//
// Question: does v dominate p over w?
// Computes: with c_v the number of points of the closed segment vp on the bisector Vor{v,w}, and
//   c_w that of the segment wp, the sign of c_w - c_v. On the ray v + t (p - v) the difference
//   f_v - f_w is A t^2 + B t - C with A = |p-v|_v^2 - |p-v|_w^2, B = 2 (p-v)^T M_w (w-v),
//   C = |w-v|_w^2 > 0, so c_v counts its distinct roots in (0, 1]; degree 6 (the discriminant).
// Returns: positive: v dominates p; negative: w does; zero: p is on the border of the territories.
// Laws: 1. exchanging v and w negates the sign; 2. v dominates its own position over w;
//   3. if v dominates p and is nearer to it, it dominates every point of the segment vp; 4. if v
//   dominates p, then f_v(p) < f_w(p) and the segment vp meets the bisector nowhere, or wp meets it
//   twice.
//   It does not hold that the nearer site dominates, nor that domination is open in the plane: in
//   the cusp behind a tangency it changes without crossing the border. Nor is a territory
//   star-shaped about its site: what w sees only through the far branch of a hyperbola is v's, with
//   w's in between (docs/math/domination.md).
// Requires: finite numbers, positive definite metrics, distinct sites. p is given by its
//   displacements from v and from w times a common weight > 0, so that no division is needed.
// Degenerate: a tangent segment counts one point; zero is an answer.
// Source: the thesis, definition 6.
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

// The difference f_v - f_w on the ray from v through p, as A t^2 + 2 H t - C with p at t = 1,
// multiplied by weight^2. The members are A, H weight, C weight^2; u = weight (p - v), d = w - v.
template <class Number>
struct ray_difference {
  Number a, half_b, c, weight;

  ray_difference(const basic_metric_tensor<Number>& metric_v,
                 const basic_metric_tensor<Number>& metric_w, const displacement<Number>& d,
                 const displacement<Number>& u, const Number& w)
      : a(squared_length(metric_v - metric_w, u)), weight(w) {
    const auto metric_w_d = apply(metric_w, d);
    half_b = dot(u, metric_w_d);
    c = dot(d, metric_w_d);
  }

  // Returns the number of roots in (0, 1), given that the difference is negative at t = 1: 0, 1
  // (tangent) or 2.
  uncertain_int roots_before_negative_end() const {
    // Decides most cases by the product of two roots in (0, 1): it is -C/A, and below 1.
    const uncertain_bool steep = is_negative(sign_of(a + c * square(weight)));
    if (steep.certainly(false)) return 0;
    const uncertain_bool top_inside = is_negative(sign_of(a + half_b * weight));
    if (top_inside.certainly(false)) return 0;
    const uncertain_bool bulge =
        top_inside & is_negative(sign_of(a)) & is_positive(sign_of(half_b));
    if (bulge.certainly(false)) return 0;
    const uncertain_sign discriminant = sign_of(square(half_b) + a * c);
    if (discriminant.certainly(sign::negative)) return 0;
    if (!bulge.certain() || !discriminant.certain()) return {};
    return discriminant.value() == sign::zero ? 1 : 2;
  }

  // Returns the number of roots in (0, 1], given that t = 1 is a root. The other root is -C/A,
  // which lies in (0, 1) iff A + C < 0.
  uncertain_int roots_up_to_zero_end() const {
    const uncertain_bool second = is_negative(sign_of(a + c * square(weight)));
    return second.certain() ? uncertain_int(second.value() ? 2 : 1) : uncertain_int();
  }
};

// The point p, by its weighted displacements from both sites: from_v = weight (p - v), from_w
// likewise.
template <class Number>
uncertain_sign dominates(const basic_site<Number>& v, const basic_site<Number>& w,
                         const displacement<Number>& from_v, const displacement<Number>& from_w,
                         const Number& weight) {
  const auto d = between(v.position, w.position);
  const auto seen_from_v = [&] {
    return ray_difference<Number>(v.metric, w.metric, d, from_v, weight);
  };
  const auto seen_from_w = [&] {
    return ray_difference<Number>(w.metric, v.metric, -d, from_w, weight);
  };
  const uncertain_sign nearer =
      sign_of(squared_length(v.metric, from_v) - squared_length(w.metric, from_w));
  if (!nearer.certain()) return {};
  // Starts from one point of the bisector on each segment: f_v - f_w changes sign once on the
  // segment from the farther site to p, so that its count stays 1; other counts are computed.
  uncertain_int of_v = 1, of_w = 1;
  if (nearer.value() == sign::negative) of_v = seen_from_v().roots_before_negative_end();
  if (nearer.value() == sign::positive) of_w = seen_from_w().roots_before_negative_end();
  if (nearer.value() == sign::zero) {
    of_v = seen_from_v().roots_up_to_zero_end();
    of_w = seen_from_w().roots_up_to_zero_end();
  }
  if (!of_v.certain() || !of_w.certain()) return {};
  return to_sign(of_w.value() - of_v.value());
}

template <class Number>
uncertain_sign dominates(const basic_site<Number>& v, const basic_site<Number>& w,
                         const basic_point<Number>& p) {
  return dominates(v, w, between(v.position, p), between(w.position, p), Number(1));
}

}  // namespace asterism::internal
