// SPDX-License-Identifier: MIT
//
// Decides signs of functions along a visible arc (predicates/visible_arc.hpp) in exact numbers: at
// a dyadic parameter, at a real root of a polynomial, and where they may change.
#pragma once

#include "asterism/core/square_root_sum.hpp"
#include "asterism/kernels/root_line.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal::exact {

using arc = visible_arc<dyadic>;

// Returns the sign of f at p(m). Requires E(m) >= 0.
inline sign sign_at(const arc& on, const arc_function<dyadic>& f, const dyadic& m) {
  const dyadic radicand = on.e(m);
  return square_root_sum(on.rational_part(f)(m), f.beta(m), radicand).sign_value();
}

template <std::size_t Degree>
sign sign_at(const polynomial<dyadic, Degree>& p, real_root& root) {
  return root.sign_of_value(dense_polynomial(p));
}

// Returns the sign of f at the point of the arc with parameter `root`.
inline sign sign_at(const arc& on, const arc_function<dyadic>& f, real_root& root) {
  const sign p = sign_at(on.rational_part(f), root);
  const sign beta = sign_at(f.beta, root);
  if (p == beta || beta == sign::zero) return p;
  if (p == sign::zero) return beta;
  return p * sign_at(on.norm(f), root);  // P^2 against beta^2 E; C > 0
}

inline bool is_on_arc(const arc& on, real_root& root) {
  return sign_at(on.e, root) == sign::positive &&
         (sign_at(on.h, root) == sign::positive || sign_at(on.a, root) == sign::positive);
}

// Cuts the line at every zero of f along the arc.
inline void add_zeros(root_line& line, const arc& on, const arc_function<dyadic>& f, unsigned tag) {
  const dense_polynomial norm(on.norm(f));
  if (!norm.is_zero()) {
    line.add(norm, tag);
    return;
  }
  // Cuts at the zeros of P and of beta: where the norm is the zero polynomial, f is 2 P or 0 in
  // each section between these.
  line.add(dense_polynomial(on.rational_part(f)), tag);
  line.add(dense_polynomial(f.beta), tag);
}

}  // namespace asterism::internal::exact
