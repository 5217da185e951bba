// SPDX-License-Identifier: MIT
//
// Question: does q lie in wedge(v, w), where both sites see the other at less than 90 degrees?
// Computes: signs of (q - v)^T M_v (w - v) and (q - w)^T M_w (v - w); degree 3.
// Returns: true when both are positive; the border is outside.
// Laws: 1. symmetric in v and w; 2. the open segment vw lies inside, its ends do not;
//   3. on the bisector Vor{v,w}, inside the wedge means visible from both v and w
//   (docs/math/visible-arc.md). It does not hold that a wedged point is nearer to v or w than to
//   anything else.
// Requires: finite numbers, positive definite metrics, distinct sites.
// Source: the thesis, definition 3.
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

// Returns (q - v)^T M_v (w - v): positive where v sees q at less than 90 degrees from w.
template <class Number>
Number wedge_value(const basic_site<Number>& v, const basic_point<Number>& w,
                   const basic_point<Number>& q) {
  return dot(between(v.position, q), apply(v.metric, between(v.position, w)));
}

template <class Number>
uncertain_bool in_wedge(const basic_site<Number>& v, const basic_site<Number>& w,
                        const basic_point<Number>& q) {
  return is_positive(sign_of(wedge_value(v, w.position, q))) &
         is_positive(sign_of(wedge_value(w, v.position, q)));
}

}  // namespace asterism::internal
