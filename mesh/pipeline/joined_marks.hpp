// SPDX-License-Identifier: MIT
//
// Converts marks by the vertices of a mesh's file to marks by the vertices of the mesh with its
// slits joined.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh_marks.hpp"

namespace asterism::internal {

// Returns the marks by the mesh's vertex numbers. `number` has the mesh's vertex number of each
// vertex of the file; where it is empty the marks stay as they are.
inline mesh_marks joined_marks(mesh_marks marks, const std::vector<vertex_index>& number) {
  if (number.empty()) return marks;
  for (auto* const list : {&marks.corners, &marks.required_vertices})
    for (vertex_index& v : *list) v = number[v];
  for (auto& edge : marks.required_edges)
    for (vertex_index& v : edge) v = number[v];
  return marks;
}

}  // namespace asterism::internal
