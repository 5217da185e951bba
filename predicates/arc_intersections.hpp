// SPDX-License-Identifier: MIT
//
// Question: in how many points of the visible arc of v, w is x as near as v and w?
// Computes: the zeros of f_v - f_x along the arc, an expression P(m) + beta(m) sqrt E(m) of the
//   parameter whose zeros are among those of a quartic; each is kept when it lies on the arc and
//   P and beta do not have the same sign there.
// Returns: the number of distinct points strictly inside wedge(v, w), or -1 when infinitely many.
// Laws: 1. symmetric in v and w; 2. at most voronoi_vertex_count(v, w, x) when that is not -1.
//   It does not hold that exchanging x with v or w keeps it.
// Requires: finite numbers, positive definite metrics, three distinct sites.
// Degenerate: -1 asks for infinitely many *wedged* points; common points elsewhere do not count.
// Source: the thesis, section 4.1 and appendix A, step 2b.
#pragma once

#include "asterism/predicates/visible_arc.hpp"
#include "asterism/predicates/voronoi_vertices.hpp"

namespace asterism::internal {

// True if P + beta sqrt E is zero, by the signs of P and beta. Requires that the norm P^2 - beta^2
// E is zero.
inline uncertain_bool conjugate_vanishes(uncertain_sign rational_part, uncertain_sign beta) {
  if (!rational_part.certain() || !beta.certain()) return {};
  return rational_part.value() * beta.value() != sign::positive;
}

// True if some root of the polynomial is a parameter of the arc.
template <class Arithmetic, class Number, class Root>
uncertain_bool is_root_on_arc(const visible_arc<Number>& arc, Root& root) {
  const uncertain_bool real = is_positive(Arithmetic::sign_at(arc.e, root));
  if (real.certainly(false)) return real;
  return real & (is_positive(Arithmetic::sign_at(arc.h, root)) |
                 is_positive(Arithmetic::sign_at(arc.a, root)));
}

// Decides on which zeros f has, given that its norm vanishes identically: true if f is zero on a
// whole section of the arc, false if f is zero at common zeros of P and beta alone.
template <class Arithmetic, class Number>
uncertain_bool vanishes_on_a_section(const visible_arc<Number>& arc, const arc_function<Number>& f,
                                     const polynomial<Number, 2>& rational_part) {
  const auto samples = Arithmetic::samples(arc.e, arc.h, arc.a, rational_part, f.beta);
  if (!samples.has_value()) return {};
  for (const Number& m : *samples) {
    const uncertain_bool inside = arc.contains(Number(1), m);
    if (!inside.certain()) return {};
    if (!inside.value()) continue;
    const uncertain_sign value = Arithmetic::function_sign(arc, f, m);
    if (!value.certain()) return {};
    if (value.value() == sign::zero) return true;
  }
  return false;
}

// Returns the number of roots that lie on the arc and at which f is zero, by is_zero_at(root);
// undecided if the roots are not known.
template <class Arithmetic, class Number, class Roots, class IsZero>
uncertain_int count_zeros_on_arc(const visible_arc<Number>& arc, Roots roots,
                                 const IsZero& is_zero_at) {
  if (!roots.has_value()) return {};
  int found = 0;
  for (auto& root : *roots) {
    const uncertain_bool inside = is_root_on_arc<Arithmetic>(arc, root);
    if (inside.certainly(false)) continue;
    const uncertain_bool zero = is_zero_at(root);
    if (zero.certainly(false)) continue;
    if (!inside.certain() || !zero.certain()) return {};
    ++found;
  }
  return found;
}

// Arithmetic as in voronoi_vertices.hpp, and Arithmetic::function_sign(arc, f, lambda, mu), the
// sign of f at a parameter; Arithmetic::samples(...) one parameter in each section between the
// roots of the polynomials given, or nothing.
template <class Arithmetic, class Number>
uncertain_int arc_intersection_count(const visible_arc<Number>& arc, const basic_site<Number>& x) {
  const auto f = arc.restrict(distance_difference(arc.v, x));
  const auto norm = arc.norm(f);
  const auto p = arc.rational_part(f);
  const uncertain_bool no_norm = vanishes(norm);
  if (!no_norm.certain()) return {};
  if (!no_norm.value())
    return count_zeros_on_arc<Arithmetic>(arc, Arithmetic::real_roots(norm), [&](auto& root) {
      const uncertain_sign beta = Arithmetic::sign_at(f.beta, root);
      return conjugate_vanishes(Arithmetic::sign_at(p, root), beta);
    });
  const uncertain_bool everywhere = vanishes_on_a_section<Arithmetic>(arc, f, p);
  if (!everywhere.certain()) return {};
  if (everywhere.value()) return -1;
  // Uses that f = 2 P on the arc wherever beta is not zero: the zeros of f are the common zeros of
  // P and beta.
  const uncertain_bool no_p = vanishes(p);
  if (!no_p.certain()) return {};
  if (no_p.value()) return 0;
  return count_zeros_on_arc<Arithmetic>(arc, Arithmetic::real_roots(p), [&](auto& root) {
    return is_zero(Arithmetic::sign_at(f.beta, root));
  });
}

}  // namespace asterism::internal
