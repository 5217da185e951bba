// SPDX-License-Identifier: MIT
//
// Decides the sign of a polynomial on a whole range of parameters, from its Bernstein coefficients:
// certain only where it has no zero. On intervals and on exact numbers alike.
#pragma once

#include <cmath>

#include "asterism/core/polynomial.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

// A range of parameters: the open interval (low, high), ends may be infinite, not both.
struct parameter_range {
  double low, high;
};

// Returns p(x + shift).
template <class Number, std::size_t Degree>
polynomial<Number, Degree> taylor_shift(polynomial<Number, Degree> p, const Number& shift) {
  for (std::size_t i = 0; i < Degree; ++i)
    for (std::size_t j = Degree; j-- > i;)
      p.coefficient[j] = p.coefficient[j] + shift * p.coefficient[j + 1];
  return p;
}

// Returns p in coordinates that are positive on the range: coefficients of one sign then show that
// p keeps that sign on it (Descartes; up to binomial factors these are Bernstein coefficients). The
// first one is p at a finite end, the last one p at the other end or the leading coefficient.
template <class Number, std::size_t Degree>
polynomial<Number, Degree> over_range(const polynomial<Number, Degree>& p,
                                      const parameter_range& range) {
  if (std::isinf(range.low)) {
    // Makes the polynomial p(high - t) in t > 0.
    polynomial<Number, Degree> q = taylor_shift(p, Number(range.high));
    for (std::size_t k = 1; k <= Degree; k += 2) q.coefficient[k] = Number(0) - q.coefficient[k];
    return q;
  }
  polynomial<Number, Degree> q = taylor_shift(p, Number(range.low));
  if (std::isinf(range.high)) return q;  // p(low + t), t > 0
  // Makes the polynomial p(low + width / (1 + t)) (1 + t)^Degree in t > 0.
  const Number width = Number(range.high) - Number(range.low);
  polynomial<Number, Degree> reversed;
  Number power(1);
  for (std::size_t k = 0; k <= Degree; ++k) {
    reversed.coefficient[Degree - k] = q.coefficient[k] * power;
    if (k < Degree) power = power * width;
  }
  for (std::size_t i = 0; i < Degree; ++i)
    for (std::size_t j = Degree; j-- > i;)
      reversed.coefficient[j] = reversed.coefficient[j] + reversed.coefficient[j + 1];
  return reversed;
}

// Returns the sign of p on the range and at its finite ends; certain only when p has no zero there.
template <class Number, std::size_t Degree>
uncertain_sign sign_between(const polynomial<Number, Degree>& p, const parameter_range& range) {
  const polynomial<Number, Degree> form = over_range(p, range);
  // Takes the last coefficient, which belongs to an infinite end or to the finite end `low`.
  const bool both_finite = !std::isinf(range.low) && !std::isinf(range.high);
  sign common = sign::zero;
  for (std::size_t j = 0; j <= Degree; ++j) {
    const uncertain_sign s = sign_of(form.coefficient[j]);
    if (!s.certain()) return {};
    if (s.value() == sign::zero) {
      // Leaves a zero at a finite end undecided: good and bad points may touch there, and a tie is
      // not a "no".
      if (j == 0 || (j == Degree && both_finite)) return {};
      continue;
    }
    if (common != sign::zero && common != s.value()) return {};
    common = s.value();
  }
  return common == sign::zero ? uncertain_sign() : uncertain_sign(common);
}
}  // namespace asterism::internal
