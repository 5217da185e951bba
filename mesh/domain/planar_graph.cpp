// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/planar_graph.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/domain/message_names.hpp"
#include "asterism/mesh/domain/repair_tally.hpp"

namespace asterism::internal {

namespace {

std::vector<vertex_index> vertices_by_place(const domain& d) {
  std::vector<vertex_index> order(d.vertices.size());
  std::iota(order.begin(), order.end(), vertex_index{0});
  std::stable_sort(order.begin(), order.end(), [&](vertex_index i, vertex_index j) {
    return lexicographically_less(d.vertices[i], d.vertices[j]);
  });
  return order;
}

// Returns the first index of each run of equal points; `order` is cut down to these.
std::vector<vertex_index> merge_vertices(const domain& d, std::vector<vertex_index>& order) {
  std::vector<vertex_index> first_alike(d.vertices.size());
  std::vector<vertex_index> distinct;
  for (const vertex_index v : order) {
    if (distinct.empty() || d.vertices[distinct.back()] != d.vertices[v]) distinct.push_back(v);
    first_alike[v] = distinct.back();
  }
  order = std::move(distinct);
  return first_alike;
}

void report_merged(const domain& d, const std::vector<vertex_index>& first_alike,
                   domain_repairs& repairs) {
  const domain_names names(d);
  repair_tally merged(repairs.merged_vertices);
  for (std::size_t v = 0; v < first_alike.size(); ++v)
    if (first_alike[v] != v)
      merged.add([&] { return names.at_vertex(v); },
                 [&] { return names.vertex(v) + " is " + names.vertex(first_alike[v]); });
  merged.report("repeated vertices merged", repairs.messages);
}

bool in_box_of(const point& a, const point& b, const point& q) {
  return std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= q.y &&
         q.y <= std::max(a.y, b.y);
}

// Returns the vertices on the segment between a and b, ends included, from a to b.
std::vector<vertex_index> vertices_along(const domain& d, const std::vector<vertex_index>& by_place,
                                         vertex_index a, vertex_index b,
                                         const filtered_kernel& kernel) {
  const point& pa = d.vertices[a];
  const point& pb = d.vertices[b];
  const auto less = [&](vertex_index i, const point& p) {
    return lexicographically_less(d.vertices[i], p);
  };
  const auto [low, high] = std::minmax(pa, pb, lexicographically_less);
  std::vector<vertex_index> along;
  for (auto at = std::lower_bound(by_place.begin(), by_place.end(), low, less);
       at != by_place.end() && !lexicographically_less(high, d.vertices[*at]); ++at) {
    const bool is_end = *at == a || *at == b;
    if (is_end || (in_box_of(pa, pb, d.vertices[*at]) &&
                   kernel.orientation(pa, pb, d.vertices[*at]) == sign::zero))
      along.push_back(*at);
  }
  // Orders points on one line lexicographically, which is the order along it.
  if (lexicographically_less(pb, pa)) std::reverse(along.begin(), along.end());
  return along;
}

std::vector<covered_edge> cut_segments(const domain& d,
                                       const std::vector<vertex_index>& first_alike,
                                       const std::vector<vertex_index>& by_place,
                                       domain_repairs& repairs) {
  const filtered_kernel kernel;
  const domain_names names(d);
  repair_tally no_length(repairs.segments_without_length), split(repairs.split_segments);
  std::vector<covered_edge> subsegments;
  for (std::size_t s = 0; s < d.segments.size(); ++s) {
    const auto place = [&] { return names.at_segment(s); };
    const vertex_index a = first_alike[d.segments[s].a], b = first_alike[d.segments[s].b];
    if (a == b) {
      no_length.add(place, [&] { return names.segment(s); });
      continue;
    }
    const std::vector<vertex_index> along = vertices_along(d, by_place, a, b, kernel);
    if (along.size() > 2)
      split.add(place, [&] { return names.segment(s) + " at " + names.vertex(along[1]); });
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      subsegments.push_back({along[i], along[i + 1], s, d.segments[s].marker});
  }
  no_length.report("segments without length dropped", repairs.messages);
  split.report("segments split at vertices on them", repairs.messages);
  return subsegments;
}

// Keeps the first of the subsegments between the same two vertices.
void unite_subsegments(const domain& d, const std::vector<covered_edge>& subsegments,
                       plane_graph& graph, domain_repairs& repairs) {
  const domain_names names(d);
  repair_tally repeated(repairs.repeated_subsegments);
  std::map<std::pair<vertex_index, vertex_index>, std::size_t> kept_at;
  std::vector<covered_edge>& kept = graph.edges;
  for (const covered_edge& e : subsegments) {
    const auto [at, is_new] = kept_at.try_emplace(std::minmax(e.a, e.b), kept.size());
    graph.coverings.push_back({at->second, e.source});
    if (is_new) {
      kept.push_back(e);
      continue;
    }
    covered_edge& first = kept[at->second];
    ++first.covered;
    if (first.marker == 0) first.marker = e.marker;
    repeated.add([&] { return names.at_segment(e.source); },
                 [&] {
                   return names.segment(e.source) + " on " + names.segment(first.source) +
                          names.line_of_segment(first.source);
                 });
  }
  repeated.report("overlapping segments united", repairs.messages);
}

// Tests edges without a common vertex; after the cutting they can meet only by crossing.
bool cross(const domain& d, const covered_edge& e, const covered_edge& f,
           const filtered_kernel& kernel) {
  if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return false;
  const point &a = d.vertices[e.a], &b = d.vertices[e.b];
  const point &c = d.vertices[f.a], &g = d.vertices[f.b];
  if (std::max(c.y, g.y) < std::min(a.y, b.y) || std::max(a.y, b.y) < std::min(c.y, g.y))
    return false;
  return kernel.orientation(a, b, c) * kernel.orientation(a, b, g) == sign::negative &&
         kernel.orientation(c, g, a) * kernel.orientation(c, g, b) == sign::negative;
}

// Returns the two crossing edges whose sources come first.
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(
    const domain& d, const std::vector<covered_edge>& edges) {
  const filtered_kernel kernel;
  const auto low_x = [&](const covered_edge& e) {
    return std::min(d.vertices[e.a].x, d.vertices[e.b].x);
  };
  const auto high_x = [&](const covered_edge& e) {
    return std::max(d.vertices[e.a].x, d.vertices[e.b].x);
  };
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return low_x(edges[i]) < low_x(edges[j]); });
  std::optional<std::pair<std::size_t, std::size_t>> first;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const covered_edge& e = edges[order[i]];
    for (std::size_t j = i + 1; j < order.size() && low_x(edges[order[j]]) <= high_x(e); ++j) {
      const std::pair<std::size_t, std::size_t> sources =
          std::minmax(e.source, edges[order[j]].source);
      if ((!first || sources < *first) && cross(d, e, edges[order[j]], kernel)) first = sources;
    }
  }
  return first;
}

}  // namespace

result<plane_graph> build_plane_graph(const domain& d, domain_repairs& repairs) {
  const std::size_t told = repairs.messages.size();
  std::vector<vertex_index> by_place = vertices_by_place(d);
  plane_graph graph;
  graph.first_alike = merge_vertices(d, by_place);
  report_merged(d, graph.first_alike, repairs);
  unite_subsegments(d, cut_segments(d, graph.first_alike, by_place, repairs), graph, repairs);
  // Drops messages about merged vertices and subsegments of polygons: rings that meet list their
  // common corners and sides once for each ring, which is no fault of the domain.
  if (!d.polygons.empty()) repairs.messages.resize(told);
  if (const auto crossing = find_crossing(d, graph.edges)) {
    const domain_names names(d);
    const auto [s, t] = *crossing;
    return error{names.at_segment(t) + names.segment(t) + " crosses " + names.segment(s) +
                 names.line_of_segment(s)};
  }
  return graph;
}

}  // namespace asterism::internal
