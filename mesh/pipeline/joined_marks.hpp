// SPDX-License-Identifier: MIT
//
// Brings the marks of a mesh's file to the numbers of the mesh with its slits joined.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh_marks.hpp"

namespace asterism::internal {

// Returns the marks in these numbers, one for each vertex of the file; as they are where there are
// none.
inline mesh_marks joined_marks(mesh_marks marks, const std::vector<vertex_index>& number) {
  if (number.empty()) return marks;
  for (auto* const list : {&marks.corners, &marks.required_vertices})
    for (vertex_index& v : *list) v = number[v];
  for (auto& edge : marks.required_edges)
    for (vertex_index& v : edge) v = number[v];
  return marks;
}

}  // namespace asterism::internal
