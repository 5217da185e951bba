// SPDX-License-Identifier: MIT
//
// Question: does v dominate p over w?
// Computes: with c_v the number of points of the closed segment vp on the bisector Vor{v,w}, and
//   c_w that of the segment wp, the sign of c_w - c_v. On the ray v + t (p - v) the difference
//   f_v - f_w is A t^2 + B t - C with A = |p-v|_v^2 - |p-v|_w^2, B = 2 (p-v)^T M_w (w-v),
//   C = |w-v|_w^2 > 0, so c_v counts its distinct roots in (0, 1]; degree 6 (the discriminant).
// Returns: positive: v dominates p; negative: w does; zero: p is on the border of the territories.
// Laws: 1. exchanging v and w negates the sign; 2. v dominates its own position over w;
//   3. each territory is star-shaped about its site; 4. if v dominates p, then f_v(p) < f_w(p) and
//   the segment vp meets the bisector nowhere, or wp meets it twice.
//   It does not hold that the nearer site dominates, nor that domination is open in the plane: in
//   the cusp behind a tangency it changes without crossing the border.
// Requires: finite numbers, positive definite metrics, distinct sites. p is given by its
//   displacements from v and from w times a common weight > 0, so that no division is needed.
// Degenerate: a tangent segment counts one point; zero is an answer.
// Source: the thesis, definition 6.
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism {

// Distinct points of the closed segment from v to p on Vor{v,w}: 0, 1 or 2.
// u = weight * (p - v), d = w - v.
template <class Number>
uncertain_int bisector_crossings(const basic_metric_tensor<Number>& metric_v,
                                 const basic_metric_tensor<Number>& metric_w,
                                 const displacement<Number>& d, const displacement<Number>& u,
                                 const Number& weight) {
  const auto metric_w_d = apply(metric_w, d);
  const Number a = squared_length(metric_v - metric_w, u);
  const Number half_b = dot(u, metric_w_d);
  const Number b = half_b + half_b;
  const Number c = dot(d, metric_w_d);
  const Number b_weighted = b * weight;
  const uncertain_sign at_p = sign_of(a + b_weighted - c * square(weight));
  if (!at_p.certain()) return {};
  if (at_p.value() == sign::positive) return 1;  // a quadratic that changes sign once
  if (at_p.value() == sign::zero) {
    // t = 1 is one root; the other one, -C/A, lies in (0, 1) iff A + C < 0.
    const uncertain_bool second = is_negative(sign_of(a + c * square(weight)));
    return second.certain() ? uncertain_int(second.value() ? 2 : 1) : uncertain_int();
  }
  const uncertain_bool bulge = is_negative(sign_of(a)) & is_positive(sign_of(half_b)) &
                               is_negative(sign_of(a + a + b_weighted));
  if (bulge.certainly(false)) return 0;
  const uncertain_sign discriminant = sign_of(square(half_b) + a * c);
  if (discriminant.certainly(sign::negative)) return 0;
  if (!bulge.certain() || !discriminant.certain()) return {};
  return discriminant.value() == sign::zero ? 1 : 2;
}

// p by its weighted displacements from both sites: from_v = weight (p - v), from_w likewise.
template <class Number>
uncertain_sign dominates(const basic_site<Number>& v, const basic_site<Number>& w,
                         const displacement<Number>& from_v, const displacement<Number>& from_w,
                         const Number& weight) {
  const auto d = between(v.position, w.position);
  const uncertain_int of_v = bisector_crossings(v.metric, w.metric, d, from_v, weight);
  if (!of_v.certain()) return {};
  const uncertain_int of_w = bisector_crossings(w.metric, v.metric, -d, from_w, weight);
  if (!of_w.certain()) return {};
  return to_sign(of_w.value() - of_v.value());
}

template <class Number>
uncertain_sign dominates(const basic_site<Number>& v, const basic_site<Number>& w,
                         const basic_point<Number>& p) {
  return dominates(v, w, between(v.position, p), between(w.position, p), Number(1));
}

}  // namespace asterism
