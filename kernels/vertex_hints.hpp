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
#include "asterism/predicates/insertion_test.hpp"

namespace asterism::internal::numeric {

// Returns a point with f_v = f_w = f_x, as its displacement from v: Newton's method from the centre
// of the circle in the sum of the three metrics, until a step is at most `last_step` of the
// displacement. Steps become smaller by their squares: the error is about the square of the last.
inline std::optional<displacement<double>> voronoi_vertex_near(const basic_site<double>& v,
                                                               const basic_site<double>& w,
                                                               const basic_site<double>& x,
                                                               double last_step = 0x1p-24) {
  const auto to_w = between(v.position, w.position), to_x = between(v.position, x.position);
  const metric_tensor sum{v.metric.m11 + w.metric.m11 + x.metric.m11,
                          v.metric.m12 + w.metric.m12 + x.metric.m12,
                          v.metric.m22 + w.metric.m22 + x.metric.m22};
  const auto sum_w = apply(sum, to_w), sum_x = apply(sum, to_x);
  const double half_w = 0.5 * dot(to_w, sum_w), half_x = 0.5 * dot(to_x, sum_x);
  const double determinant = cross(sum_w, sum_x);
  displacement<double> p{(half_w * sum_x.y - half_x * sum_w.y) / determinant,
                         (sum_w.x * half_x - sum_x.x * half_w) / determinant};
  constexpr int most_steps = 8;
  for (int step = 0; step < most_steps; ++step) {
    const auto from_w = p - to_w, from_x = p - to_x;
    const auto at_v = apply(v.metric, p), at_w = apply(w.metric, from_w),
               at_x = apply(x.metric, from_x);
    const double f_v = dot(p, at_v);
    const double excess_w = 0.5 * (f_v - dot(from_w, at_w)),
                 excess_x = 0.5 * (f_v - dot(from_x, at_x));
    const auto slope_w = at_v - at_w, slope_x = at_v - at_x;
    const double slopes = cross(slope_w, slope_x);
    const displacement<double> move{(excess_w * slope_x.y - excess_x * slope_w.y) / slopes,
                                    (slope_w.x * excess_x - slope_x.x * excess_w) / slopes};
    p = p - move;
    const double size = std::abs(p.x) + std::abs(p.y);
    if (std::abs(move.x) + std::abs(move.y) <= last_step * size) return p;
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
