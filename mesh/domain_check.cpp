// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain_check.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/mesh/domain_faces.hpp"
#include "asterism/mesh/domain_graph.hpp"
#include "asterism/mesh/domain_names.hpp"
#include "asterism/mesh/domain_repair_tally.hpp"

namespace asterism {

namespace {

using failure = std::optional<error>;

bool is_finite(const point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

failure check_values(const domain& d) {
  const domain_names names(d);
  if (d.vertices.size() > std::numeric_limits<index>::max() / 4)
    return error{names.at_start() + "more vertices than 32-bit numbers can name"};
  for (std::size_t v = 0; v < d.vertices.size(); ++v)
    if (!is_finite(d.vertices[v]))
      return error{names.at_vertex(v) + names.vertex(v) + " is not finite"};
  for (std::size_t s = 0; s < d.segments.size(); ++s)
    if (d.segments[s].a >= d.vertices.size() || d.segments[s].b >= d.vertices.size())
      return error{names.at_segment(s) + names.segment(s) + " uses a vertex that does not exist"};
  for (std::size_t h = 0; h < d.holes.size(); ++h)
    if (!is_finite(d.holes[h])) return error{names.at_hole(h) + names.hole(h) + " is not finite"};
  if (d.segments.empty())
    return error{names.at_start() + "the domain is empty: it has no segments"};
  return {};
}

failure check_closed(const domain& d, const plane_graph& graph) {
  std::vector<std::size_t> degree(d.vertices.size(), 0);
  for (const graph_edge& e : graph.edges) {
    ++degree[e.a];
    ++degree[e.b];
  }
  const domain_names names(d);
  for (std::size_t v = 0; v < degree.size(); ++v) {
    if (degree[v] != 1) continue;
    for (const graph_edge& e : graph.edges)
      if (e.a == v || e.b == v)
        return error{names.at_segment(e.source) + "the boundary is not closed at " +
                     names.vertex(v) + ", the end of " + names.segment(e.source) + " alone"};
  }
  return {};
}

// Which faces are removed: the outside, and those around hole points.
result<std::vector<bool>> removed_faces(const domain& d, const plane_graph& graph,
                                        const face_map& faces) {
  const domain_names names(d);
  std::vector<bool> removed(2 * graph.edges.size() + 1, false);
  removed[face_map::outside] = true;
  for (std::size_t h = 0; h < d.holes.size(); ++h) {
    const std::size_t edge = faces.edge_through(d.holes[h]);
    if (edge < graph.edges.size()) {
      const std::size_t s = graph.edges[edge].source;
      return error{names.at_hole(h) + names.hole(h) + " lies on " + names.segment(s) +
                   names.line_of_segment(s)};
    }
    const std::size_t face = faces.face_around(d.holes[h]);
    if (face == face_map::outside)
      return error{names.at_hole(h) + names.hole(h) + " lies outside of the domain"};
    removed[face] = true;
  }
  return removed;
}

// Turns the edges with the domain on one side so that it is on their left; drops those without.
result<std::vector<graph_edge>> boundary_edges(const domain& d, const plane_graph& graph,
                                               const face_map& faces,
                                               const std::vector<bool>& removed,
                                               domain_repairs& repairs) {
  const domain_names names(d);
  repair_tally outer(repairs.outer_pieces);
  std::vector<graph_edge> kept;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    graph_edge e = graph.edges[i];
    const bool inside_left = !removed[faces.left_of(2 * i)];
    const bool inside_right = !removed[faces.left_of(2 * i + 1)];
    if (inside_left && inside_right)
      return error{names.at_segment(e.source) + names.segment(e.source) +
                   " lies inside the domain: internal segments are not supported yet (or a hole "
                   "point is missing)"};
    if (!inside_left && !inside_right) {
      outer.add([&] { return names.at_segment(e.source); },
                [&] { return names.segment(e.source); });
      continue;
    }
    if (inside_right) std::swap(e.a, e.b);
    kept.push_back(e);
  }
  outer.report("segments outside of the domain dropped", repairs.messages);
  if (kept.empty())
    return error{names.at_start() + "the domain is empty: the holes leave nothing of it"};
  return kept;
}

// Vertices of the boundary, and loose ones inside, in their order; the rest is counted.
std::vector<bool> kept_vertices(const domain& d, const plane_graph& graph, const face_map& faces,
                                const std::vector<bool>& removed,
                                const std::vector<graph_edge>& boundary, domain_repairs& repairs) {
  const domain_names names(d);
  std::vector<bool> kept(d.vertices.size(), false), on_segment(d.vertices.size(), false);
  for (const graph_edge& e : graph.edges) on_segment[e.a] = on_segment[e.b] = true;
  for (const graph_edge& e : boundary) kept[e.a] = kept[e.b] = true;
  repair_tally dropped(repairs.dropped_vertices);
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (kept[v] || graph.first_alike[v] != v) continue;
    kept[v] = !on_segment[v] && !removed[faces.face_around(d.vertices[v])];
    if (!kept[v]) dropped.add([&] { return names.at_vertex(v); }, [&] { return names.vertex(v); });
  }
  dropped.report("vertices outside of the domain dropped", repairs.messages);
  return kept;
}

domain assemble(const domain& d, const std::vector<bool>& kept,
                const std::vector<graph_edge>& boundary) {
  domain accepted;
  accepted.name = d.name;
  std::vector<index> renumbered(d.vertices.size(), 0);
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (!kept[v]) continue;
    renumbered[v] = static_cast<index>(accepted.vertices.size());
    accepted.vertices.push_back(d.vertices[v]);
  }
  for (const graph_edge& e : boundary)
    accepted.segments.push_back({renumbered[e.a], renumbered[e.b], e.marker});
  // A hole that shared a segment with the outside is a part of it now, and needs no point.
  const face_map faces(d.vertices, boundary);
  for (const point& hole : d.holes)
    if (faces.face_around(hole) != face_map::outside) accepted.holes.push_back(hole);
  return accepted;
}

}  // namespace

result<domain> check_domain(const domain& input, domain_repairs* repairs) {
  domain_repairs unasked;
  domain_repairs& report = repairs != nullptr ? *repairs : unasked;
  report = {};
  if (auto failed = check_values(input)) return std::move(*failed);
  const auto graph = build_plane_graph(input, report);
  if (!graph.ok()) return graph.failure();
  if (auto failed = check_closed(input, graph.value())) return std::move(*failed);
  const face_map faces(input.vertices, graph.value().edges);
  const auto removed = removed_faces(input, graph.value(), faces);
  if (!removed.ok()) return removed.failure();
  const auto boundary = boundary_edges(input, graph.value(), faces, removed.value(), report);
  if (!boundary.ok()) return boundary.failure();
  return assemble(
      input, kept_vertices(input, graph.value(), faces, removed.value(), boundary.value(), report),
      boundary.value());
}

}  // namespace asterism
