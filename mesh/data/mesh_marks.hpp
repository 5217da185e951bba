// SPDX-License-Identifier: MIT
//
// Parts of a mesh that its file says must stay.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Medit's Corners, RequiredVertices and RequiredEdges, the last by their ends.
struct mesh_marks {
  std::vector<vertex_index> corners, required_vertices;
  std::vector<std::array<vertex_index, 2>> required_edges;
};

// A mesh with its marks.
struct marked_mesh {
  mesh subject;
  mesh_marks marks;
};

}  // namespace asterism
