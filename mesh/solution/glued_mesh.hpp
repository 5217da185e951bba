// SPDX-License-Identifier: MIT
//
// Holds a mesh that is continued across its boundary, for functions that are periodic.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// A mesh, and copies of some of its triangles beyond its periodic sides.
struct glued_mesh {
  mesh continued;                    // the first vertices and triangles are the mesh's own
  std::vector<vertex_index> origin;  // of each vertex, the own one that has its value
  // Pairs of own vertices that are one place: in this order the second gets the value of the first.
  std::vector<std::array<vertex_index, 2>> partners;
};

}  // namespace asterism
