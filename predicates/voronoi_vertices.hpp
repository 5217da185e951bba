// SPDX-License-Identifier: MIT
//
// Question: in how many points do the bisectors of three sites meet?
// Computes: with r = p - u and coordinates turned so that the y^2 coefficients do not vanish, the
//   two conics g_1 = f_u - f_v and g_2 = f_u - f_w give the line pencil b(x) y + c(x) = 0 that
//   passes through every common point, and the resultant R = alpha c^2 - beta b c + gamma b^2 of
//   degree 4 whose real roots are the common points' x. Over a root with b = 0 the pencil says
//   nothing, and g_1 is solved for y there.
// Returns: the number of distinct real points, 0 to 4, or -1 when there are infinitely many.
// Laws: 1. symmetric in all three sites; 2. -1 iff the two conics share a line or are equal;
//   3. with three equal metrics: 1, or 0 when the sites are collinear. It does not hold that a
//   Voronoi vertex is wedged, nor that three close sites have one.
// Requires: finite numbers, positive definite metrics, three distinct sites.
// Degenerate: tangencies count once; a point where one conic is a crossing of two lines is one.
// Source: the thesis, section 4.1, "Voronoi vertices in the 3-site diagram (at most 4)".
#pragma once

#include <array>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/polynomial.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal {

// A conic over x, as a polynomial alpha y^2 + beta(x) y + gamma(x) in y.
template <class Number>
struct conic_in_y {
  Number alpha;
  polynomial<Number, 1> beta;
  polynomial<Number, 2> gamma;
};

// Returns the conic in axes x' along `first` and y' along `second`: r = x' first + y' second.
template <class Number>
conic_in_y<Number> along_axes(const plane_quadratic<Number>& g, const displacement<Number>& first,
                              const displacement<Number>& second) {
  const auto form_first = apply(g.form, first), form_second = apply(g.form, second);
  const Number mixed = dot(first, form_second);
  return {dot(second, form_second),
          {{dot(g.linear, second), mixed + mixed}},
          {{g.constant, dot(g.linear, first), dot(first, form_first)}}};
}

// Returns the number of points over x where g = 0, a polynomial in y: by the sign of its
// discriminant there.
inline uncertain_int points_over(uncertain_sign discriminant) {
  return discriminant.certain() ? uncertain_int(1 + to_int(discriminant.value())) : uncertain_int();
}

// Arithmetic::real_roots(p) yields the distinct real roots of a polynomial that does not vanish,
// or nothing when undecided; Arithmetic::sign_at(p, root) the sign of p at one of them.
template <class Arithmetic, class Number>
uncertain_int count_common_points(const conic_in_y<Number>& g1, const conic_in_y<Number>& g2) {
  const auto b = g2.alpha * g1.beta - g1.alpha * g2.beta;
  const auto c = g2.alpha * g1.gamma - g1.alpha * g2.gamma;
  const Number four(4);
  const auto discriminant = g1.beta * g1.beta - (four * g1.alpha) * g1.gamma;
  const uncertain_bool no_pencil = vanishes(b), no_constant = vanishes(c);
  if (!no_pencil.certain()) return {};
  const polynomial<Number, 4> resultant =
      g1.alpha * (c * c) - g1.beta * (b * c) + g1.gamma * (b * b);
  if (no_pencil.value()) {
    if (!no_constant.certain()) return {};
    if (no_constant.value()) return -1;
  } else {
    const uncertain_bool common_line = vanishes(resultant);
    if (!common_line.certain()) return {};
    if (common_line.value()) return -1;
  }
  const auto sum_over_roots = [&](auto&& roots) -> uncertain_int {
    if (!roots.has_value()) return {};
    int count = 0;
    for (auto& root : *roots) {
      const uncertain_sign slope = Arithmetic::sign_at(b, root);
      if (!slope.certain()) return {};
      const uncertain_int points = slope.value() != sign::zero
                                       ? uncertain_int(1)
                                       : points_over(Arithmetic::sign_at(discriminant, root));
      if (!points.certain()) return {};
      count += points.value();
    }
    return count;
  };
  return no_pencil.value() ? sum_over_roots(Arithmetic::real_roots(c))
                           : sum_over_roots(Arithmetic::real_roots(resultant));
}

// Counts the vertices where one conic is the line linear . r + constant = 0, two metrics being
// equal.
template <class Arithmetic, class Number>
uncertain_int count_points_on_line(const plane_quadratic<Number>& line,
                                   const plane_quadratic<Number>& conic) {
  // Substitutes r = (x J linear - constant linear) / k into the conic, with k = |linear|^2, and
  // multiplies by k^2.
  const displacement<Number> normal = line.linear, along{Number(0) - normal.y, normal.x};
  const Number k = dot(normal, normal);
  const displacement<Number> foot = (Number(0) - line.constant) * normal;
  const auto form_along = apply(conic.form, along);
  const Number mixed = dot(foot, form_along);
  const polynomial<Number, 2> restricted{
      {squared_length(conic.form, foot) + k * dot(conic.linear, foot) + square(k) * conic.constant,
       mixed + mixed + k * dot(conic.linear, along), dot(along, form_along)}};
  const uncertain_bool contained = vanishes(restricted);
  if (!contained.certain()) return {};
  if (contained.value()) return -1;
  auto roots = Arithmetic::real_roots(restricted);
  return roots.has_value() ? uncertain_int(static_cast<int>(roots->size())) : uncertain_int();
}

template <class Arithmetic, class Number>
uncertain_int voronoi_vertex_count(const basic_site<Number>& u, const basic_site<Number>& v,
                                   const basic_site<Number>& w) {
  const auto g1 = distance_difference(u, v), g2 = distance_difference(u, w);
  const auto is_line = [](const plane_quadratic<Number>& g) {
    return is_zero(sign_of(g.form.m11)) & is_zero(sign_of(g.form.m12)) &
           is_zero(sign_of(g.form.m22));
  };
  const uncertain_bool line1 = is_line(g1), line2 = is_line(g2);
  if (!line1.certain() || !line2.certain()) return {};
  if (line1.value()) return count_points_on_line<Arithmetic>(g1, g2);
  if (line2.value()) return count_points_on_line<Arithmetic>(g2, g1);
  // Tries five directions: two quadratic forms that are not zero vanish in at most four directions
  // together.
  constexpr std::array<std::array<int, 2>, 5> directions = {
      {{0, 1}, {1, 1}, {1, 2}, {1, -1}, {2, -1}}};
  for (const auto& direction : directions) {
    const Number x(direction[0]), y(direction[1]);
    const displacement<Number> second{x, y}, first{y, Number(0) - x};
    const auto conic1 = along_axes(g1, first, second), conic2 = along_axes(g2, first, second);
    const uncertain_bool usable =
        (!is_zero(sign_of(conic1.alpha))) & (!is_zero(sign_of(conic2.alpha)));
    if (usable.certainly(true)) return count_common_points<Arithmetic>(conic1, conic2);
  }
  return {};
}

}  // namespace asterism::internal
