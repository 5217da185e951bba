// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

using ends = std::array<vertex_index, 2>;

ends sorted(vertex_index a, vertex_index b) { return {std::min(a, b), std::max(a, b)}; }

std::size_t sides_with_one_triangle(const triangle_sides& sides) {
  return static_cast<std::size_t>(
      std::count_if(sides.all().begin(), sides.all().end(),
                    [&](const auto& s) { return sides.find(s.ends[1], s.ends[0]) == nullptr; }));
}

// True if some inner edge is not among the internal ones of the list.
bool leaves_one_out(const mesh& m, const triangle_sides& sides) {
  std::vector<ends> listed;
  for (const boundary_edge& e : m.boundary)
    if (e.internal) listed.push_back(sorted(e.a, e.b));
  std::sort(listed.begin(), listed.end());
  return std::any_of(sides.all().begin(), sides.all().end(), [&](const auto& s) {
    const auto [a, b] = s.ends;
    return a < b && sides.find(b, a) != nullptr &&
           !std::binary_search(listed.begin(), listed.end(), s.ends);
  });
}

}  // namespace

std::vector<int> vertex_references(const mesh& m) {
  std::vector<int> references(m.sites.size(), 0);
  for (const boundary_edge& e : m.boundary)
    for (const vertex_index v : {e.a, e.b})
      if (v < references.size() && references[v] == 0) references[v] = e.marker;
  return references;
}

void keep_segments(mesh& m, const triangle_sides& sides, const edge_marks& marks) {
  for (boundary_edge& e : m.boundary) {
    const bool left = sides.find(e.a, e.b) != nullptr, right = sides.find(e.b, e.a) != nullptr;
    if (right && !left) std::swap(e.a, e.b);
    e.internal = left && right;
  }
  if (marks.all) return;
  const bool by_reference = leaves_one_out(m, sides);
  std::vector<boundary_edge> kept;
  for (std::size_t i = 0; i < m.boundary.size(); ++i) {
    const boundary_edge& e = m.boundary[i];
    if (!e.internal || marks.required[i] != 0 || (by_reference && e.marker != 0) ||
        sides.divides_regions(m.regions, e.a, e.b))
      kept.push_back(e);
  }
  m.boundary = std::move(kept);
}

void list_sides(mesh& m, const triangle_sides& sides) {
  if (m.boundary.empty()) return;
  std::vector<ends> listed;
  for (const boundary_edge& e : m.boundary) listed.push_back(sorted(e.a, e.b));
  std::sort(listed.begin(), listed.end());
  const std::size_t before = m.boundary.size();
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<ends>& found) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [a, b] = sides.all()[i].ends;
      if (sides.find(b, a) == nullptr &&
          !std::binary_search(listed.begin(), listed.end(), sorted(a, b)))
        found.push_back({a, b});
    }
  };
  constexpr std::size_t sides_at_once = 16384;  // for a thread
  for (const auto& [a, b] : collect_chunks<ends>(sides.all().size(), sides_at_once, append))
    m.boundary.push_back({a, b, static_cast<vertex_index>(m.boundary.size()), 0, false});
  const std::size_t added = m.boundary.size() - before;
  if (added == 0) return;
  const point &p = m.sites[m.boundary[before].a].position,
              &q = m.sites[m.boundary[before].b].position;
  m.notes.push_back(
      fmt::format("{} of {} boundary edges are not listed and have marker 0, the "
                  "first from ({:g}, {:g}) to ({:g}, {:g})",
                  added, sides_with_one_triangle(sides), p.x, p.y, q.x, q.y));
}

}  // namespace asterism::internal
