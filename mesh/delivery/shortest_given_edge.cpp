// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/shortest_given_edge.hpp"

#include <algorithm>

#include "asterism/core/elementary.hpp"

namespace asterism::internal {
namespace {

// Returns the longer side of the box around all sites.
double width_of(const mesh& m) {
  point low = m.sites.front().position, high = low;
  for (const site& s : m.sites) {
    low = {std::min(low.x, s.position.x), std::min(low.y, s.position.y)};
    high = {std::max(high.x, s.position.x), std::max(high.y, s.position.y)};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

}  // namespace

std::optional<given_edge> shortest_given_edge(const mesh& m) {
  std::optional<given_edge> shortest;
  const auto consider = [&](vertex_index a, vertex_index b) {
    if (a >= m.given || b >= m.given) return;
    const point &p = m.sites[a].position, &q = m.sites[b].position;
    const double length = elementary::hypot(q.x - p.x, q.y - p.y);
    if (!shortest || length < shortest->length)
      shortest =
          given_edge{std::min(a, b), std::max(a, b), m.sites[std::min(a, b)].position, length, 0};
  };
  for (const boundary_edge& e : m.boundary) consider(e.a, e.b);
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) consider(t[i], t[(i + 1) % 3]);
  if (shortest) shortest->part_of_width = shortest->length / width_of(m);
  return shortest;
}

std::optional<close_vertices> too_close_in(const mesh_outcome& outcome) {
  const auto edge = shortest_given_edge(outcome.result);
  if (outcome.complete || outcome.stopped || !edge || !is_rounding(*edge)) return std::nullopt;
  return close_vertices{edge->a, edge->b, edge->at, edge->length};
}

}  // namespace asterism::internal
