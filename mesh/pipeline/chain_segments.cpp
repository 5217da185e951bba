// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/chain_segments.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace asterism::internal {
namespace {

// Walks along chains of boundary edges, listed by vertex.
class chain_walk {
 public:
  chain_walk(const mesh& m, vertex_index given) : m_(m), given_(given), at_(m.sites.size()) {
    for (std::size_t e = 0; e < m.boundary.size(); ++e) {
      at_[m.boundary[e].a].push_back(e);
      at_[m.boundary[e].b].push_back(e);
    }
  }

  // Returns the edges from a vertex of the domain, beginning with edge `first`, to the next vertex
  // of the domain, and that vertex; empty where the chain branches or ends before.
  std::vector<std::size_t> from(vertex_index begin, std::size_t first, vertex_index& end) const {
    std::vector<std::size_t> chain;
    vertex_index v = begin;
    for (std::size_t e = first; chain.size() <= m_.boundary.size();) {
      chain.push_back(e);
      v = m_.boundary[e].a == v ? m_.boundary[e].b : m_.boundary[e].a;
      end = v;
      if (v < given_) return chain;
      if (at_[v].size() != 2) break;
      e = at_[v][0] == e ? at_[v][1] : at_[v][0];
    }
    return {};
  }

 private:
  const mesh& m_;
  vertex_index given_;
  std::vector<std::vector<std::size_t>> at_;
};

}  // namespace

void number_segments_by_chains(mesh& m, const domain& shape) {
  std::map<std::pair<vertex_index, vertex_index>, vertex_index> segments;
  for (std::size_t s = 0; s < shape.segments.size(); ++s)
    segments[std::minmax(shape.segments[s].a, shape.segments[s].b)] = static_cast<vertex_index>(s);
  const auto given = static_cast<vertex_index>(shape.vertices.size());
  const chain_walk walk(m, given);
  std::vector<std::pair<std::size_t, vertex_index>> found;
  for (std::size_t e = 0; e < m.boundary.size(); ++e)
    for (const vertex_index begin : {m.boundary[e].a, m.boundary[e].b}) {
      if (begin >= given) continue;
      vertex_index end = begin;
      const std::vector<std::size_t> chain = walk.from(begin, e, end);
      const auto segment = segments.find(std::minmax(begin, end));
      if (segment == segments.end()) continue;
      for (const std::size_t part : chain) found.emplace_back(part, segment->second);
    }
  for (const auto& [edge, number] : found) m.boundary[edge].segment = number;
}

}  // namespace asterism::internal
