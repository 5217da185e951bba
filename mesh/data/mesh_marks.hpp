// SPDX-License-Identifier: MIT
//
// Holds the parts of a mesh that its file marks as required.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Medit's Corners, RequiredVertices and RequiredEdges, edges by their two
// ends.
struct mesh_marks {
  std::vector<vertex_index> corners, required_vertices;
  std::vector<std::array<vertex_index, 2>> required_edges;
};

// A mesh with the marks of its file.
struct marked_mesh {
  mesh subject;
  mesh_marks marks;
};

}  // namespace asterism
