// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/periodic_partners.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <string>

namespace asterism::internal {
namespace {

using line = std::vector<vertex_index>;  // the vertices of a side, in their order

std::string marker_text(int marker) { return "marker " + std::to_string(marker); }

// Returns the vertices of one side in order from its start to its end.
result<line> line_of(const mesh& m, int marker) {
  std::map<vertex_index, vertex_index> next;
  std::map<vertex_index, std::size_t> arriving;
  for (std::size_t e = 0; e < m.boundary.size(); ++e) {
    const boundary_edge& edge = m.boundary[e];
    if (edge.marker != marker) continue;
    if (edge.a >= m.sites.size() || edge.b >= m.sites.size())
      return error{"boundary edge " + std::to_string(e + 1) + " names a vertex that is not there"};
    for (const vertex_index v : {edge.a, edge.b})
      if (!std::isfinite(m.sites[v].position.x) || !std::isfinite(m.sites[v].position.y))
        return error{"vertex " + std::to_string(v + 1) + " is at no finite place"};
    if (edge.internal)
      return error{"boundary edge " + std::to_string(e + 1) + " with " + marker_text(marker) +
                   " has the domain on both sides"};
    if (!next.emplace(edge.a, edge.b).second || ++arriving[edge.b] > 1)
      return error{"the edges with " + marker_text(marker) + " branch"};
  }
  if (next.empty()) return error{"no boundary edge has " + marker_text(marker)};
  line found;
  for (const auto& [start, end] : next)
    if (!arriving.contains(start)) found.push_back(start);
  if (found.empty())
    return error{"the edges with " + marker_text(marker) + " are a closed line, without ends"};
  if (found.size() > 1)
    return error{"the edges with " + marker_text(marker) + " are more than one line"};
  for (auto step = next.find(found.front()); step != next.end(); step = next.find(found.back()))
    found.push_back(step->second);
  if (found.size() != next.size() + 1)
    return error{"the edges with " + marker_text(marker) + " are more than one line"};
  return found;
}

}  // namespace

result<std::vector<std::array<vertex_index, 2>>> periodic_partners(const mesh& m, int first,
                                                                   int second) {
  if (first == second) return error{"a side is no partner of itself"};
  const auto from = line_of(m, first), to = line_of(m, second);
  if (!from) return from.failure();
  if (!to) return to.failure();
  const std::size_t count = from.value().size();
  if (count != to.value().size())
    return error{"they have " + std::to_string(count) + " and " +
                 std::to_string(to.value().size()) + " vertices"};
  std::vector<std::array<vertex_index, 2>> found;
  for (std::size_t i = 0; i < count; ++i)
    found.push_back({from.value()[i], to.value()[count - 1 - i]});
  return found;
}

}  // namespace asterism::internal
