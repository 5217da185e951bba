// SPDX-License-Identifier: MIT
//
// Proposes parameters to try first along an arc, in plain doubles: the parameters at which x and y
// become as near as v and w, from Newton's method on the Voronoi vertices of v, w, x and v, w, y.
// For close sites of a smooth metric field these are the only cuts that matter. Without a
// guarantee: arc_search proves what it uses.
#pragma once

#include <cmath>
#include <optional>

#include "asterism/kernels/double_arithmetic.hpp"
#include "asterism/kernels/two_doubles.hpp"
#include "asterism/predicates/insertion_test.hpp"

namespace asterism::internal::numeric {

// Solves two linear equations by Cramer's rule. Each lane has the coefficients and the right side
// of one.
inline two_doubles solution_of(const two_displacements& coefficients, two_doubles right) {
  const double determinant = difference(coefficients.x * exchanged(coefficients.y));
  const two_doubles x = right * exchanged(coefficients.y), y = coefficients.x * exchanged(right);
  return (pair(x[0], y[0]) - pair(x[1], y[1])) / both(determinant);
}

// Returns a point with f_v = f_w = f_x, as its displacement from v: Newton's method from the centre
// of the circle in the sum of the three metrics, until a step is at most `last_step` of the
// displacement. Steps become smaller by their squares: the error is about the square of the last.
// Has values of w and x side by side, and those of v twice.
inline std::optional<displacement<double>> voronoi_vertex_near(const basic_site<double>& v,
                                                               const basic_site<double>& w,
                                                               const basic_site<double>& x,
                                                               double last_step = 0x1p-24) {
  const two_displacements to{pair(w.position.x, x.position.x) - v.position.x,
                             pair(w.position.y, x.position.y) - v.position.y};
  const metric_tensor& m = v.metric;
  const two_doubles m11 = pair(w.metric.m11, x.metric.m11), m12 = pair(w.metric.m12, x.metric.m12),
                    m22 = pair(w.metric.m22, x.metric.m22);
  const double sum11 = m.m11 + w.metric.m11 + x.metric.m11,
               sum12 = m.m12 + w.metric.m12 + x.metric.m12,
               sum22 = m.m22 + w.metric.m22 + x.metric.m22;
  const two_displacements in_sum{sum11 * to.x + sum12 * to.y, sum12 * to.x + sum22 * to.y};
  two_doubles p = solution_of(in_sum, 0.5 * (to.x * in_sum.x + to.y * in_sum.y));
  constexpr int most_steps = 8;
  for (int step = 0; step < most_steps; ++step) {
    const two_displacements from_v{both(p[0]), both(p[1])}, from = from_v - to;
    const two_displacements at_v{m.m11 * from_v.x + m.m12 * from_v.y,
                                 m.m12 * from_v.x + m.m22 * from_v.y},
        at{m11 * from.x + m12 * from.y, m12 * from.x + m22 * from.y};
    const two_doubles f_v = from_v.x * at_v.x + from_v.y * at_v.y,
                      excess = 0.5 * (f_v - (from.x * at.x + from.y * at.y));
    const two_doubles move = solution_of(at_v - at, excess);
    p = p - move;
    const double size = sum(absolute(p));
    if (sum(absolute(move)) <= last_step * size) return displacement<double>{p[0], p[1]};
    if (!(size < std::numeric_limits<double>::max())) return std::nullopt;
  }
  return std::nullopt;
}

// Returns the parameter of the Voronoi vertex of v, w and x, if one is found on the arc.
inline std::optional<double> vertex_parameter(const visible_arc<double>& arc,
                                              const basic_site<double>& x) {
  const auto p = voronoi_vertex_near(arc.v, arc.w, x);
  if (!p) return std::nullopt;
  const auto seen = apply(arc.v.metric, *p);
  const double along_d = dot(arc.d, seen);
  // Computes coordinates of p along d and n, which are orthogonal in v's metric.
  const double m = dot(arc.n, seen) * squared_length(arc.v.metric, arc.d) /
                   (along_d * squared_length(arc.v.metric, arc.n));
  return along_d > 0 && arc.contains(1.0, m).value() ? std::optional(m) : std::nullopt;
}

// Proposes parameters to show the answer "no": below `high` the condition of one neighbour fails,
// above `low` that of the other, and low < high. Takes one sample between low and high and one on
// either side, close enough to stay on the arc.
inline search_hints hints_around_overlap(const visible_arc<double>& arc, double low, double high) {
  search_hints hints;
  hints.extent = find_extent(arc);
  const double aside = 0.5 * (high - low);
  const auto push_on_arc = [&](double end, double step) {
    for (int halving = 0; halving < 3; ++halving, step *= 0.125)
      if (arc.contains(1.0, end + step).value()) {
        hints.samples[hints.count++] = end + step;
        return;
      }
  };
  push_on_arc(low, -aside);
  hints.samples[hints.count++] = 0.5 * (low + high);
  push_on_arc(high, aside);
  return hints;
}

// Proposes parameters for the common case: x and y on different sides of the line vw, one cut each.
inline std::optional<search_hints> find_quick_hints(const insertion_question<double>& question) {
  const visible_arc<double>& arc = question.arc;
  const double side_x = cross(arc.d, question.at_x.v_to_x),
               side_y = cross(arc.d, question.at_y.v_to_x);
  if (!(side_x * side_y < 0)) return std::nullopt;
  const auto at_x = vertex_parameter(arc, question.at_x.x),
             at_y = vertex_parameter(arc, question.at_y.x);
  if (!at_x || !at_y) return std::nullopt;
  // Orders the cuts: n turns left, so a neighbour on the left allows parameters below its cut, one
  // on the right those above.
  const double lower_end = side_x > 0 ? *at_y : *at_x, upper_end = side_x > 0 ? *at_x : *at_y;
  if (!(lower_end < upper_end)) return hints_around_overlap(arc, upper_end, lower_end);
  search_hints hints;
  hints.witness = 0.5 * (lower_end + upper_end);
  hints.samples[hints.count++] = *hints.witness;
  return hints;
}

}  // namespace asterism::internal::numeric
