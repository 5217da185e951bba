// SPDX-License-Identifier: MIT
//
// Point 2, the combinatorial part: every directed edge once, its reverse once or the boundary; both
// at an internal edge.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/support/sort_by_counting.hpp"

namespace asterism::internal::audit_detail {
namespace {

std::string edge_text(const audit_context& context, const directed_edge& edge) {
  return "edge " + number_of(context, edge.a) + "-" + number_of(context, edge.b) + " of " +
         triangle_text(context, edge.triangle);
}

// Packs an edge's ends into one key, ordered by a, then b: one comparison in place of two.
std::uint64_t in_one_number(vertex_index a, vertex_index b) {
  constexpr int bits = 32;
  return std::uint64_t{a} << bits | b;
}

// Returns the edge of triangle t that leaves its corner i.
directed_edge edge_of(const std::vector<triangle>& triangles, vertex_index t, std::size_t i) {
  const triangle& c = triangles[t];
  return {c[i], c[(i + 1) % 3], c[(i + 2) % 3], t};
}

// Sorts edges by counting for a, and by comparisons among edges with the same a: linear where
// degrees are bounded. The cost for vertices of any degree has the bound of std::sort.
void list_edges(audit_context& context) {
  const auto& triangles = context.subject.triangles;
  const std::size_t sites = context.subject.sites.size();
  const auto& listed = context.triangles;
  resize_in_threads(context.edges, 3 * listed.size());
  auto& start = context.edge_start;
  start = sort_by_counting(
      context.edges.size(), sites,
      [&](std::size_t k) { return std::size_t{triangles[listed[k / 3]][k % 3]}; },
      [&](std::size_t at, std::size_t k) {
        context.edges[at] = edge_of(triangles, listed[k / 3], k % 3);
      });
  const auto at = [&](std::size_t i) {
    return context.edges.begin() + static_cast<std::ptrdiff_t>(i);
  };
  check_in_parallel(context, sites, [&](audit_tally&, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      std::sort(at(start[v]), at(start[v + 1]), [](const auto& l, const auto& r) {
        return in_one_number(l.b, l.triangle) < in_one_number(r.b, r.triangle);
      });
  });
}

void list_sides(audit_context& context) {
  for (const vertex_index subsegment : context.subsegments) {
    const boundary_edge& e = context.subject.boundary[subsegment];
    context.sides.push_back({e.a, e.b, subsegment});
    if (e.internal) context.sides.push_back({e.b, e.a, subsegment});
  }
  std::sort(context.sides.begin(), context.sides.end(), [](const auto& l, const auto& r) {
    return std::array{l.a, l.b, l.subsegment} < std::array{r.a, r.b, r.subsegment};
  });
  context.side_start = starts_of(context.sides, context.subject.sites.size());
}

void check_repeated(const audit_context& context, audit_tally& tally, std::size_t i) {
  const directed_edge &e = context.edges[i], &before = context.edges[i - 1];
  if (before.b == e.b)
    tally.found(finding_kind::repeated_edge, edge_text(context, e) +
                                                 " runs the same way in triangle " +
                                                 number_of(context, before.triangle));
}

// Checks that the reverse of one edge exists, or that it is a boundary edge. `arrivals` are the
// starts of all edges that end where this one begins, sorted.
void check_matched(const audit_context& context, audit_tally& tally, const directed_edge& e,
                   const std::vector<vertex_index>& arrivals) {
  if (!std::binary_search(arrivals.begin(), arrivals.end(), e.b) &&
      find_subsegment(context, e.a, e.b) == context.subject.boundary.size())
    tally.found(finding_kind::unmatched_edge,
                edge_text(context, e) + " has no triangle across and is no boundary edge");
}

// True if each edge's end is among `arrivals`. Compares all pairs: for lists this short, sorting
// would cost more in mispredicted branches.
bool all_are_matched(std::span<const directed_edge> edges,
                     const std::vector<vertex_index>& arrivals) {
  constexpr std::size_t most_compared = 16;
  if (arrivals.size() > most_compared) return false;
  int all = 1;
  for (const directed_edge& e : edges) {
    int is_matched = 0;
    for (const vertex_index from : arrivals) is_matched |= static_cast<int>(from == e.b);
    all &= is_matched;
  }
  return all != 0;
}

// Checks a vertex's outgoing edges against the edges that reach it, which are found in the
// triangles around the vertex. Around an interior vertex both lists have the same far ends.
// `arrivals` is scratch.
void check_edges_from(const audit_context& context, audit_tally& tally, std::size_t v,
                      std::vector<vertex_index>& arrivals) {
  const auto& edges = context.edges;
  const std::size_t first = context.edge_start[v], last = context.edge_start[v + 1];
  arrivals.clear();
  for (std::size_t i = first; i < last; ++i) arrivals.push_back(edges[i].apex);
  for (std::size_t i = first + 1; i < last; ++i) check_repeated(context, tally, i);
  if (all_are_matched(std::span(edges).subspan(first, last - first), arrivals)) return;
  std::sort(arrivals.begin(), arrivals.end());
  for (std::size_t i = first; i < last; ++i) check_matched(context, tally, edges[i], arrivals);
}

void check_triangle_edges(audit_context& context) {
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    std::vector<vertex_index> arrivals;
    for (std::size_t v = begin; v < end; ++v) check_edges_from(context, tally, v, arrivals);
  };
  check_in_parallel(context, context.subject.sites.size(), check);
}

void check_subsegments(audit_context& context) {
  const auto& sides = context.sides;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const directed_subsegment& side = sides[i];
    const boundary_edge& subsegment = context.subject.boundary[side.subsegment];
    const auto text = [&] { return subsegment_text(context, side.subsegment); };
    if (i > 0 && sides[i - 1].a == side.a && sides[i - 1].b == side.b)
      context.found(
          finding_kind::repeated_boundary,
          text() + " repeats boundary edge " + number_of(context, sides[i - 1].subsegment));
    if (find_edge(context, side.a, side.b) == context.edges.size())
      context.found(
          finding_kind::boundary_without_triangle,
          text() + " has no triangle on its " + (side.a == subsegment.a ? "left" : "right"));
    const std::size_t other_side = find_edge(context, side.b, side.a);
    if (!subsegment.internal && other_side != context.edges.size())
      context.found(finding_kind::boundary_inside,
                    text() + " has " + triangle_text(context, context.edges[other_side].triangle) +
                        " on its right");
  }
}

void check_closed_curves(audit_context& context) {
  std::vector<int> balance(context.subject.sites.size(), 0);
  for (const directed_subsegment& side : context.sides) {  // internal ones cancel out
    ++balance[side.a];
    --balance[side.b];
  }
  for (vertex_index v = 0; v < balance.size(); ++v)
    if (balance[v] != 0)
      context.found(finding_kind::open_boundary,
                    std::to_string(std::abs(balance[v])) + " more boundary edges " +
                        (balance[v] > 0 ? "leave " : "reach ") + vertex_text(context, v) +
                        (balance[v] > 0 ? " than reach it" : " than leave it"));
}

void check_used(audit_context& context, vertex_index v) {
  if (context.edge_start[v] == context.edge_start[v + 1])
    context.found(finding_kind::unused_vertex, vertex_text(context, v) + " is in no triangle");
}

// Replaces the edges of these triangles in the sorted list.
void replace_edges(audit_context& context, const std::vector<vertex_index>& of) {
  const auto& triangles = context.subject.triangles;
  auto& edges = context.edges;
  std::vector<char> is_replaced(triangles.size(), 0);
  for (const vertex_index t : of) is_replaced[t] = 1;
  std::erase_if(edges, [&](const directed_edge& e) { return is_replaced[e.triangle] != 0; });
  const auto kept = static_cast<std::ptrdiff_t>(edges.size());
  for (const vertex_index t : of)
    for (std::size_t i = 0; i < 3; ++i) edges.push_back(edge_of(triangles, t, i));
  const auto is_before = [](const directed_edge& l, const directed_edge& r) {
    return std::array{l.a, l.b, l.triangle} < std::array{r.a, r.b, r.triangle};
  };
  std::sort(edges.begin() + kept, edges.end(), is_before);
  std::inplace_merge(edges.begin(), edges.begin() + kept, edges.end(), is_before);
  context.edge_start = starts_of(edges, context.subject.sites.size());
}

}  // namespace

void check_edges(audit_context& context) {
  list_edges(context);
  list_sides(context);
  check_triangle_edges(context);
  check_subsegments(context);
  check_closed_curves(context);
  for (vertex_index v = 0; v < context.subject.sites.size(); ++v) check_used(context, v);
}

void check_edges_again(audit_context& context, const triangulation_changes& changes) {
  replace_edges(context, changes.triangles);
  check_in_parallel(context, changes.corners.size(),
                    [&](audit_tally& tally, std::size_t begin, std::size_t end) {
                      std::vector<vertex_index> arrivals;
                      for (std::size_t i = begin; i < end; ++i)
                        check_edges_from(context, tally, changes.corners[i], arrivals);
                    });
  check_subsegments(context);
  for (const vertex_index v : changes.corners) check_used(context, v);
}

}  // namespace asterism::internal::audit_detail
