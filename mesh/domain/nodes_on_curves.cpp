// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/nodes_on_curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/curve_chords.hpp"

namespace asterism::internal {
namespace {

double distance_of_points(const point& p, const point& q) {
  return elementary::hypot(q.x - p.x, q.y - p.y);
}

// True if a vertex of a chord is on its curve. One that split the chord on its own line is off by a
// part of the chord's height; rounding is far below a millionth of the chord.
bool is_on_curve(const curve_chords& chords, const domain& shape, vertex_index number,
                 const mesh& m, vertex_index v) {
  const segment& s = shape.segments[number];
  if (v == s.a || v == s.b) return true;
  constexpr double part = 1e-9;
  const point& q = m.sites[v].position;
  const auto place = chords.nearest(number, q);
  return place && distance_of_points(*place, q) <=
                      part * distance_of_points(shape.vertices[s.a], shape.vertices[s.b]);
}

}  // namespace

std::vector<side_node> nodes_on_curves(const mesh& m, const domain& shape) {
  std::vector<side_node> made;
  const curve_chords chords(shape);
  for (const boundary_edge& e : m.boundary) {
    if (!chords.is_chord(e.segment)) continue;
    if (!is_on_curve(chords, shape, e.segment, m, e.a) ||
        !is_on_curve(chords, shape, e.segment, m, e.b))
      continue;
    const point middle = middle_of_side(m.sites[e.a].position, m.sites[e.b].position);
    const auto place = chords.nearest(e.segment, middle);
    if (place && *place != middle) made.push_back({std::min(e.a, e.b), std::max(e.a, e.b), *place});
  }
  std::sort(made.begin(), made.end(), [](const side_node& p, const side_node& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return made;
}

}  // namespace asterism::internal
