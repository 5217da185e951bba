// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/ring_closure.hpp"

#include <cstddef>
#include <string>

#include "asterism/mesh/domain/message_names.hpp"

namespace asterism::internal {

namespace {

using edges_at = std::vector<std::vector<std::size_t>>;  // by vertex

edges_at edges_around(const domain& d, const plane_graph& graph) {
  edges_at around(d.vertices.size());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    around[graph.edges[i].a].push_back(i);
    around[graph.edges[i].b].push_back(i);
  }
  return around;
}

struct chain_end {
  vertex_index vertex = 0;
  std::size_t edge = 0;
};

// Follows the chain from the free end `start` to the next vertex that does not have exactly two
// edges.
chain_end other_end(const plane_graph& graph, const edges_at& around, vertex_index start) {
  chain_end at{start, around[start].front()};
  while (true) {
    const covered_edge& e = graph.edges[at.edge];
    at.vertex = e.a == at.vertex ? e.b : e.a;
    const auto& here = around[at.vertex];
    if (here.size() != 2) return at;
    at.edge = here[0] == at.edge ? here[1] : here[0];
  }
}

error open_chain(const domain& d, const plane_graph& graph, const edges_at& around,
                 vertex_index start) {
  const domain_names names(d);
  const std::size_t first = graph.edges[around[start].front()].source;
  const chain_end end = other_end(graph, around, start);
  const std::size_t last = graph.edges[end.edge].source;
  const std::string there =
      around[end.vertex].size() == 1
          ? "at " + names.vertex(end.vertex) + ", the end of " + names.segment(last) + " alone"
          : "comes from " + names.vertex(end.vertex);
  return {names.at_segment(first) + "the boundary is not closed: it ends at " +
          names.vertex(start) + ", the end of " + names.segment(first) + " alone, and " + there};
}

}  // namespace

std::optional<error> check_closed(const domain& d, const plane_graph& graph, const face_map& faces,
                                  const std::vector<bool>& removed) {
  const edges_at around = edges_around(d, graph);
  for (vertex_index v = 0; v < around.size(); ++v) {
    if (around[v].size() != 1) continue;
    const std::size_t edge = around[v].front();
    // Skips an edge that is traced there and back: it is a spike of a closed ring.
    if (graph.edges[edge].covered % 2 == 0) continue;
    if (removed[faces.left_of(2 * edge)]) return open_chain(d, graph, around, v);
  }
  return {};
}

}  // namespace asterism::internal
