// SPDX-License-Identifier: MIT
//
// Question: four sites meet in one point q of the visible arc of v, w, where the points allowed by
//   x and the points allowed by y touch without overlapping. Does the edge vw get the point?
// Computes: f_i becomes f_i + e_i with infinitesimals e_(1) << e_(2) << ... in the lexicographic
//   order of the sites' positions. To first order y is farther from the perturbed Voronoi vertex
//   of v, w, x by det[D_i, 1, e_i] / det[D_v, 1; D_w, 1; D_x, 1] with D_i = M_i (q - p_i) and the
//   rows of the numerator in the order v, w, x, y; the greatest site whose cofactor does not
//   vanish at q decides its sign. When v, w, x have no perturbed vertex to first order (the
//   denominator vanishes) the vertex of v, w, y is taken.
// Returns: true when the perturbed arc has good points.
// Laws: 1. symmetric under v <-> w and x <-> y; 2. with equal metrics the greatest of the four
//   cocircular sites is not on the diagonal vw.
// Degenerate: all cofactors zero (first order says nothing): false.
// Source: our own; the thesis assumes general position. Derivation: docs/math/ties.md.
#pragma once

#include <algorithm>
#include <array>

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal {

// Returns 2 D_i x D_j about `origin`, where D_s(p) = M_s (p - p_s).
template <class Number>
plane_quadratic<Number> twice_gradient_cross(const basic_point<Number>& origin,
                                             const basic_site<Number>& i,
                                             const basic_site<Number>& j) {
  const auto &a = i.metric, &b = j.metric;
  const auto at_i = apply(a, between(origin, i.position));
  const auto at_j = apply(b, between(origin, j.position));
  const Number two(2);
  const auto linear = apply(b, displacement<Number>{at_i.y, Number(0) - at_i.x}) -
                      apply(a, displacement<Number>{at_j.y, Number(0) - at_j.x});
  return {{two * (a.m11 * b.m12 - a.m12 * b.m11), a.m11 * b.m22 - a.m22 * b.m11,
           two * (a.m12 * b.m22 - a.m22 * b.m12)},
          two * linear,
          two * cross(at_i, at_j)};
}

// Returns twice det[D_i, 1; D_j, 1; D_k, 1].
template <class Number>
plane_quadratic<Number> gradient_orientation(const basic_point<Number>& origin,
                                             const basic_site<Number>& i,
                                             const basic_site<Number>& j,
                                             const basic_site<Number>& k) {
  const auto ij = twice_gradient_cross(origin, i, j), jk = twice_gradient_cross(origin, j, k),
             ki = twice_gradient_cross(origin, k, i);
  return {{ij.form.m11 + jk.form.m11 + ki.form.m11, ij.form.m12 + jk.form.m12 + ki.form.m12,
           ij.form.m22 + jk.form.m22 + ki.form.m22},
          ij.linear + jk.linear + ki.linear,
          ij.constant + jk.constant + ki.constant};
}

// `sites` are v, w, x, y. `side_allowed` states for x and for y on which side of its bisector the
// section lies that it allows: positive where that neighbour is farther than v; negative in the
// rare case that the neighbour is nearer there, but hidden behind the cells of v and w. Moving a
// hidden neighbour farther away closes the section instead of opening it. sign_at_contact(quadratic
// about v) is the exact sign at the contact q.
template <class Number, class SignAtContact>
bool tie_goes_to_edge(const std::array<basic_site<Number>, 4>& sites,
                      const std::array<point, 4>& positions,
                      const std::array<sign, 2>& side_allowed, SignAtContact&& sign_at_contact) {
  std::array<std::size_t, 4> row = {0, 1, 2, 3};
  const auto without = [&](std::size_t left_out) {
    std::array<const basic_site<Number>*, 3> kept{};
    std::size_t count = 0;
    for (std::size_t r = 0; r < 4; ++r)
      if (r != left_out) kept[count++] = &sites[row[r]];
    return sign_at_contact(gradient_orientation(sites[0].position, *kept[0], *kept[1], *kept[2]));
  };
  sign base = without(3);
  if (base == sign::zero) {
    std::swap(row[2], row[3]);
    base = without(3);
  }
  if (base == sign::zero) return false;
  std::array<std::size_t, 4> greatest_first = {0, 1, 2, 3};
  std::sort(greatest_first.begin(), greatest_first.end(), [&](std::size_t a, std::size_t b) {
    return lexicographically_less(positions[row[b]], positions[row[a]]);
  });
  for (const std::size_t r : greatest_first) {
    const sign minor = without(r);
    if (minor == sign::zero) continue;
    const sign cofactor = r % 2 == 1 ? minor : -minor;  // (-1)^(r + 3)
    return cofactor * base * side_allowed[row[3] - 2] == sign::positive;
  }
  return false;
}

// Decides the tie for equal metrics, where no cofactor vanishes: det[D, 1] is the orientation of
// the sites up to a positive factor, and the four are in convex position.
inline bool equal_metric_tie_goes_to_edge(const point& v, const point& w, const point& x,
                                          const point& y) {
  const point& of_edge = lexicographically_less(v, w) ? w : v;
  const point& of_others = lexicographically_less(x, y) ? y : x;
  return lexicographically_less(of_edge, of_others);
}

}  // namespace asterism::internal
