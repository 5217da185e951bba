// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/nodes_on_curves.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "asterism/mesh/domain/curve_chords.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"

namespace asterism::internal {
namespace {

// True if a vertex of a chord is about on its curve, not only on the chord's own line. Decides only
// which sides are curved: the auditor proves of the result that no triangle folds, and decides
// exactly which nodes are on the curve (audit/curved_triangles.hpp).
bool is_on_curve(const curve_chords& chords, const domain& shape, vertex_index number,
                 const mesh& m, vertex_index v) {
  const segment& s = shape.segments[number];
  if (v == s.a || v == s.b) return true;
  constexpr double part = 1e-9;
  const point& q = m.sites[v].position;
  const auto place = chords.nearest(number, q);
  return place && distance_between(*place, q) <=
                      part * distance_between(shape.vertices[s.a], shape.vertices[s.b]);
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
