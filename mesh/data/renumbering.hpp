// SPDX-License-Identifier: MIT
//
// Renumbers the vertices of a mesh.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Marks a vertex that is removed, in place of its new number.
inline constexpr vertex_index no_number = std::numeric_limits<vertex_index>::max();

// Moves each vertex, with its reference, to its new number, which is at most the old one. Of
// several vertices with one new number the first stays. New numbers are 0, 1, ... in the order of
// the first vertices that have them. `given` becomes the number of given vertices that stay.
// Replaces the numbers in triangles and edges, none of which may have a vertex that is removed.
inline void renumber_vertices(mesh& m, const std::vector<vertex_index>& number) {
  const bool has_references = m.references.size() == m.sites.size();
  vertex_index kept = 0, given = 0;
  for (vertex_index v = 0; v < number.size(); ++v) {
    if (number[v] != kept) continue;
    if (v < m.given) ++given;
    m.sites[kept] = m.sites[v];
    if (has_references) m.references[kept] = m.references[v];
    ++kept;
  }
  m.sites.resize(kept);
  if (has_references) m.references.resize(kept);
  m.given = given;
  for (auto* const triangles : {&m.triangles, &m.disagreeing})
    for (triangle& t : *triangles)
      for (vertex_index& v : t) v = number[v];
  for (boundary_edge& e : m.boundary) {
    e.a = number[e.a];
    e.b = number[e.b];
  }
}

}  // namespace asterism::internal
