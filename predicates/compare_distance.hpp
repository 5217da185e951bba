// SPDX-License-Identifier: MIT
//
// Question: which of two sites is nearer to q, each measuring with its own metric?
// Computes: sign of f_v(q) - f_w(q), where f_s(q) = (q - p_s)^T M_s (q - p_s); degree 3.
// Returns: negative: v is nearer; positive: w is nearer; zero: q is on the bisector Vor{v,w}.
// Laws: 1. exchanging v and w negates the sign; 2. q = p_v gives negative for distinct sites;
//   3. scaling both metrics by one positive factor keeps the sign.
//   It does not hold that the nearer site dominates q (domination.hpp).
// Requires: finite numbers, positive definite metrics.
// Degenerate: zero is an answer.
// Source: the thesis, section 3.2, d_p(q).
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

template <class Number>
Number compare_distance_value(const basic_site<Number>& v, const basic_site<Number>& w,
                              const basic_point<Number>& q) {
  return squared_length(v.metric, between(v.position, q)) -
         squared_length(w.metric, between(w.position, q));
}

template <class Number>
uncertain_sign compare_distance(const basic_site<Number>& v, const basic_site<Number>& w,
                                const basic_point<Number>& q) {
  return sign_of(compare_distance_value(v, w, q));
}

}  // namespace asterism::internal
