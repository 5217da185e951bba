// SPDX-License-Identifier: MIT
//
// Question: does w encroach upon the segment ab?
// Computes: whether some q of the open segment has f_w(q) < f_a(q) and f_w(q) < f_b(q). With
//   q = (lambda a + mu b) / (lambda + mu), lambda and mu > 0, both are signs of binary quadratic
//   forms in lambda, mu; one exact evaluation in each section between their roots decides.
// Returns: true when there is such a q; touching is false.
// Laws: 1. symmetric in a and b; 2. scaling all metrics by one positive factor keeps the answer.
//   It does not hold that w must lie near the segment in any Euclidean sense.
// Requires: finite numbers, positive definite metrics, three distinct sites.
// Degenerate: a Voronoi cell that only touches the segment does not encroach.
// Source: the thesis, definition 8: w's cell in the Voronoi diagram of a, b, w meets the segment.
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/polynomial.hpp"
#include "asterism/core/sign.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal {

template <class Number>
struct encroachment_question {
  // The two forms (f_w - f_a) (lambda + mu)^2 and (f_w - f_b) (lambda + mu)^2 as polynomials in m =
  // mu / lambda.
  polynomial<Number, 2> against_a, against_b;

  encroachment_question(const basic_site<Number>& a, const basic_site<Number>& b,
                        const basic_site<Number>& w) {
    const auto w_to_a = between(w.position, a.position), w_to_b = between(w.position, b.position),
               d = between(a.position, b.position);
    const Number at_a = squared_length(w.metric, w_to_a), at_b = squared_length(w.metric, w_to_b),
                 mixed = dot(w_to_a, apply(w.metric, w_to_b));
    against_a = {{at_a, mixed + mixed, at_b - squared_length(a.metric, d)}};
    against_b = {{at_a - squared_length(b.metric, d), mixed + mixed, at_b}};
  }

  // True if w encroaches at the point with parameter m = mu / lambda.
  uncertain_bool holds(const Number& lambda, const Number& mu) const {
    const uncertain_bool inside = is_positive(sign_of(lambda)) & is_positive(sign_of(mu));
    return inside & is_negative(sign_of(evaluate(against_a, lambda, mu))) &
           is_negative(sign_of(evaluate(against_b, lambda, mu)));
  }
};

}  // namespace asterism::internal
