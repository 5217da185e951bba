// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/trim_segments.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"

namespace asterism::internal {
namespace {

std::vector<covered_edge> edges_of(const snapped_graph& graph) {
  std::map<std::pair<vertex_index, vertex_index>, std::size_t> known;
  std::vector<covered_edge> edges;
  for (const snapped_piece& p : graph.pieces) {
    const auto [at, is_new] = known.try_emplace(std::minmax(p.a, p.b), edges.size());
    if (is_new)
      edges.push_back({p.a, p.b, p.source});
    else
      ++edges[at->second].covered;
  }
  return edges;
}

// Flags of the faces that are no part of the domain: the outside, and those with hole points in
// them.
std::set<std::size_t> removed_faces(const domain& d, const std::vector<covered_edge>& edges,
                                    const face_map& faces) {
  std::set<std::size_t> removed = {face_map::outside};
  const std::vector<std::size_t> around = faces.faces_around(d.holes);
  for (std::size_t h = 0; h < d.holes.size(); ++h)
    if (faces.edge_through(d.holes[h]) == edges.size()) removed.insert(around[h]);
  return removed;
}

class trimmer {
 public:
  trimmer(const domain& d, const snapped_graph& graph)
      : edges_(edges_of(graph)),
        faces_(graph.vertices, edges_),
        removed_(removed_faces(d, edges_, faces_)),
        around_(graph.vertices.size()) {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const vertex_index v : {edges_[e].a, edges_[e].b}) around_[v].push_back(e);
  }

  // Returns the edges by which a segment sticks out of the domain: from its free end v to the first
  // vertex with other edges. Empty if v is no free end outside of the domain, or if no edge of that
  // segment continues there.
  std::vector<std::size_t> overhang(vertex_index v) const {
    std::vector<std::size_t> chain;
    if (around_[v].size() != 1) return {};
    std::size_t e = around_[v].front();
    // Ends at an edge that is traced there and back: it is a spike of a closed ring.
    if (edges_[e].covered % 2 == 0 || !removed_.contains(faces_.left_of(2 * e))) return {};
    while (true) {
      chain.push_back(e);
      v = edges_[e].a == v ? edges_[e].b : edges_[e].a;
      if (around_[v].size() != 2) break;
      e = around_[v][0] == e ? around_[v][1] : around_[v][0];
    }
    const bool goes_on = std::any_of(around_[v].begin(), around_[v].end(), [&](std::size_t f) {
      return f != e && edges_[f].source == edges_[e].source;
    });
    return goes_on ? chain : std::vector<std::size_t>();
  }

  const covered_edge& operator[](std::size_t e) const { return edges_[e]; }

 private:
  std::vector<covered_edge> edges_;
  face_map faces_;
  std::set<std::size_t> removed_;
  std::vector<std::vector<std::size_t>> around_;
};

}  // namespace

std::vector<snapped_piece> trim_segments(const domain& d, snapped_graph& graph) {
  const trimmer chains(d, graph);
  std::vector<snapped_piece> trimmed;
  std::set<std::pair<vertex_index, vertex_index>> gone;
  for (vertex_index v = 0; v < graph.vertices.size(); ++v) {
    const std::vector<std::size_t> chain = chains.overhang(v);
    if (chain.empty()) continue;
    const covered_edge& first = chains[chain.front()];
    trimmed.push_back({v, first.a == v ? first.b : first.a, first.source});
    for (const std::size_t e : chain) gone.insert(std::minmax(chains[e].a, chains[e].b));
  }
  std::erase_if(graph.pieces,
                [&](const snapped_piece& p) { return gone.contains(std::minmax(p.a, p.b)); });
  return trimmed;
}

}  // namespace asterism::internal
