// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/medit_edges.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace asterism::internal {
namespace {

using ends = std::array<vertex_index, 2>;

std::vector<ends> sides_of(const mesh& m) {
  std::vector<ends> sides;
  sides.reserve(3 * m.triangles.size());
  for (const triangle& t : m.triangles)
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({t[i], t[(i + 1) % 3]});
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

// True if some inner edge is not among the internal ones of the list.
bool leaves_one_out(const mesh& m, const std::vector<ends>& sides) {
  std::vector<ends> listed;
  for (const boundary_edge& e : m.boundary)
    if (e.internal) listed.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
  std::sort(listed.begin(), listed.end());
  return std::any_of(sides.begin(), sides.end(), [&](const ends& s) {
    const bool inner =
        s[0] < s[1] && std::binary_search(sides.begin(), sides.end(), ends{s[1], s[0]});
    return inner && !std::binary_search(listed.begin(), listed.end(), s);
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

void keep_segments(mesh& m, const edge_marks& marks) {
  const std::vector<ends> sides = sides_of(m);
  const auto has = [&](vertex_index a, vertex_index b) {
    return std::binary_search(sides.begin(), sides.end(), ends{a, b});
  };
  for (boundary_edge& e : m.boundary) {
    const bool left = has(e.a, e.b), right = has(e.b, e.a);
    if (right && !left) std::swap(e.a, e.b);
    e.internal = left && right;
  }
  if (marks.all) return;
  const bool by_reference = leaves_one_out(m, sides);
  std::vector<boundary_edge> kept;
  for (std::size_t i = 0; i < m.boundary.size(); ++i) {
    const boundary_edge& e = m.boundary[i];
    if (!e.internal || marks.required[i] != 0 || (by_reference && e.marker != 0)) kept.push_back(e);
  }
  m.boundary = std::move(kept);
}

}  // namespace asterism::internal
