// SPDX-License-Identifier: MIT
//
// Holds a mesh that is continued across its boundary, for functions that are periodic.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// A mesh, and copies of some of its triangles where it goes on for periodic functions.
struct glued_mesh {
  mesh continued;                    // the first vertices and triangles are the mesh's own
  std::vector<vertex_index> origin;  // of each vertex, the own one that has its value
  // Own vertices that are one place: in this order, what the first has the second gets.
  std::vector<std::array<vertex_index, 2>> partners;
};

}  // namespace asterism
