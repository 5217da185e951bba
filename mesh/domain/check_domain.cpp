// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/check_domain.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "asterism/mesh/domain/curve_chains.hpp"
#include "asterism/mesh/domain/domain_values.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"
#include "asterism/mesh/domain/regions.hpp"
#include "asterism/mesh/domain/repair_tally.hpp"
#include "asterism/mesh/domain/ring_closure.hpp"

namespace asterism {
using namespace internal;

namespace {

// An edge that is kept, and the faces beside it.
struct kept_edge {
  segment s;
  std::size_t left = 0, right = 0;
};

// Returns the edges of the boundary, turned so that the domain is on their left, and the internal
// ones; all other edges are counted.
std::vector<kept_edge> kept_edges(const domain& d, const plane_graph& graph, const face_map& faces,
                                  const domain_parts& parts, domain_repairs& repairs) {
  const domain_names names(d);
  repair_tally outer(repairs.outer_subsegments);
  std::vector<kept_edge> kept;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const covered_edge& e = graph.edges[i];
    std::size_t left = faces.left_of(2 * i), right = faces.left_of(2 * i + 1);
    if (parts.removed[left] && parts.removed[right]) {
      outer.add([&] { return names.at_segment(e.source); },
                [&] { return names.segment(e.source); });
      continue;
    }
    segment s{e.a, e.b, e.marker};
    if (parts.removed[left]) {
      std::swap(s.a, s.b);
      std::swap(left, right);
    }
    s.internal = !parts.removed[right];
    s.left_region = parts.region[left];
    if (s.internal) s.right_region = parts.region[right];
    kept.push_back({s, left, right});
  }
  outer.report("segments outside of the domain dropped", repairs.messages);
  return kept;
}

// Lists the vertices of segments, and loose ones inside the domain, in their order; counts the
// others.
std::vector<bool> kept_vertices(const domain& d, const plane_graph& graph, const face_map& faces,
                                const std::vector<bool>& removed,
                                const std::vector<kept_edge>& edges, domain_repairs& repairs) {
  const domain_names names(d);
  std::vector<bool> kept(d.vertices.size(), false), on_segment(d.vertices.size(), false);
  for (const covered_edge& e : graph.edges) on_segment[e.a] = on_segment[e.b] = true;
  for (const kept_edge& e : edges) kept[e.s.a] = kept[e.s.b] = true;
  repair_tally dropped(repairs.dropped_vertices);
  std::vector<point> loose;
  for (std::size_t v = 0; v < kept.size(); ++v)
    if (!on_segment[v] && graph.first_alike[v] == v) loose.push_back(d.vertices[v]);
  const std::vector<std::size_t> around = faces.faces_around(loose);
  auto next = around.begin();
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (kept[v] || graph.first_alike[v] != v) continue;
    kept[v] = !on_segment[v] && !removed[*next++];
    if (!kept[v]) dropped.add([&] { return names.at_vertex(v); }, [&] { return names.vertex(v); });
  }
  dropped.report("vertices outside of the domain dropped", repairs.messages);
  return kept;
}

std::vector<region_point> without_limits(const domain& d, domain_repairs& repairs) {
  const domain_names names(d);
  repair_tally dropped(repairs.dropped_area_limits);
  std::vector<region_point> regions = d.regions;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (std::exchange(regions[r].largest_area, 0) != 0)
      dropped.add([&] { return names.at_region(r); }, [&] { return names.region(r); });
  dropped.report("limits on areas of triangles dropped", repairs.messages);
  return regions;
}

domain assemble(const domain& d, const std::vector<bool>& kept,
                const std::vector<kept_edge>& kept_edges, std::vector<vertex_index>& renumbered) {
  // Marks vertices that are not kept.
  constexpr vertex_index none = std::numeric_limits<vertex_index>::max();
  domain accepted;
  accepted.name = d.name;
  accepted.number_all_regions = d.number_all_regions;
  renumbered.assign(d.vertices.size(), none);
  for (std::size_t v = 0; v < kept.size(); ++v) {
    if (!kept[v]) continue;
    renumbered[v] = static_cast<vertex_index>(accepted.vertices.size());
    accepted.vertices.push_back(d.vertices[v]);
  }
  std::vector<covered_edge> edges;
  for (const kept_edge& e : kept_edges) {
    segment s = e.s;
    s.a = renumbered[s.a];
    s.b = renumbered[s.b];
    accepted.segments.push_back(s);
    edges.push_back({s.a, s.b, edges.size(), s.marker});
  }
  if (d.holes.empty()) return accepted;
  // Drops the point of a hole that shared a segment with the outside: the hole is a part of the
  // outside now.
  const face_map faces(accepted.vertices, edges);
  const std::vector<std::size_t> around = faces.faces_around(d.holes);
  for (std::size_t h = 0; h < d.holes.size(); ++h)
    if (around[h] != face_map::outside) accepted.holes.push_back(d.holes[h]);
  return accepted;
}

// Returns a polygon for each feature, around all of its parts, by the segments that are kept.
std::vector<domain_polygon> polygons_around(const polygon_faces& polygons,
                                            const std::vector<bool>& removed,
                                            const std::vector<kept_edge>& edges) {
  std::vector<domain_polygon> made;
  for (const auto& number : polygons.features) {
    made.emplace_back().region = number;
    made.back().rings.emplace_back();
  }
  for (std::uint32_t i = 0; i < edges.size() && !made.empty(); ++i) {
    const std::size_t left = polygons.feature_of[edges[i].left],
                      right = removed[edges[i].right] ? polygon_faces::none
                                                      : polygons.feature_of[edges[i].right];
    if (left == right) continue;
    for (const std::size_t feature : {left, right})
      if (feature != polygon_faces::none) made[feature].rings.front().push_back(i);
  }
  std::erase_if(made, [](const domain_polygon& p) { return p.rings.front().empty(); });
  return made;
}

result<domain> check(const domain& input, domain_repairs& report) {
  if (auto failed = check_domain_values(input)) return std::move(*failed);
  if (auto failed = check_curve_chains(input)) return std::move(*failed);
  const auto graph = build_plane_graph(input, report);
  if (!graph.ok()) return graph.failure();
  const face_map faces(input.vertices, graph.value().edges);
  // Checks first that rings are closed towards the outside: otherwise a hole or region point in an
  // open ring would be blamed.
  std::vector<bool> outside(2 * graph.value().edges.size() + 1, false);
  outside[face_map::outside] = true;
  if (auto failed = check_closed(input, graph.value(), faces, outside)) return std::move(*failed);
  const auto parts = find_parts(input, graph.value(), faces, report);
  if (!parts.ok()) return parts.failure();
  const std::vector<bool>& removed = parts.value().removed;
  if (auto failed = check_closed(input, graph.value(), faces, removed)) return std::move(*failed);
  const auto edges = kept_edges(input, graph.value(), faces, parts.value(), report);
  if (edges.empty())
    return error{domain_names(input).at_start() + "the domain is empty: " +
                 (!input.polygons.empty() ? "its polygons contain nothing"
                  : input.holes.empty()   ? "its segments enclose nothing"
                                          : "the holes leave nothing of it")};
  const auto kept = kept_vertices(input, graph.value(), faces, removed, edges, report);
  std::vector<vertex_index> renumbered;
  domain accepted = assemble(input, kept, edges, renumbered);
  accepted.polygons = polygons_around(parts.value().polygons, removed, edges);
  accepted.regions = without_limits(input, report);
  auto curves = kept_curves(input, graph.value().first_alike, renumbered, accepted);
  if (!curves) return curves.failure();
  accepted.curves = std::move(curves).value();
  return accepted;
}

}  // namespace

result<domain> check_domain(const domain& input, domain_repairs* repairs) {
  domain_repairs unasked;
  domain_repairs& report = repairs != nullptr ? *repairs : unasked;
  report = {};
  auto accepted = check(input, report);
  if (!accepted) return accepted.failure().as(error_code::invalid_domain);
  return accepted;
}

}  // namespace asterism
