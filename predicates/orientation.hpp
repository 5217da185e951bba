// SPDX-License-Identifier: MIT
//
// Question: on which side of the directed line p -> q lies r?
// Computes: sign of det(q - p, r - p); degree 2.
// Returns: positive: left, p q r turn counter-clockwise; negative: right; zero: collinear.
// Laws: 1. a cyclic change of p q r keeps the sign; 2. an exchange of two of them negates it;
//   3. equal points give zero. It does not hold that zero implies distinct points.
// Requires: finite coordinates. Degenerate: zero is an answer; the caller decides what
// collinear means. Source: the thesis uses it for "between the rays" (definition 4) and
// "strictly inside".
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

template <class Number>
Number orientation_value(const basic_point<Number>& p, const basic_point<Number>& q,
                         const basic_point<Number>& r) {
  return cross(between(p, q), between(p, r));
}

template <class Number>
uncertain_sign orientation(const basic_point<Number>& p, const basic_point<Number>& q,
                           const basic_point<Number>& r) {
  return sign_of(orientation_value(p, q, r));
}

}  // namespace asterism::internal
