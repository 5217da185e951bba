// SPDX-License-Identifier: MIT
//
// Holds a mesh that is continued across its boundary, for functions that are periodic.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Two own vertices of a mesh that are one place of a periodic function. The map that takes the
// first to the second turns by the angle with this cosine and sine.
struct glued_vertices {
  vertex_index first = 0, second = 0;
  double cosine = 1, sine = 0;
};

// A mesh, and copies of some of its triangles beyond its periodic sides.
struct glued_mesh {
  mesh continued;                    // the first vertices and triangles are the mesh's own
  std::vector<vertex_index> origin;  // of each vertex, the own one that has its value
  // In this order the second vertex gets the tensor of the first, turned.
  std::vector<glued_vertices> partners;
};

}  // namespace asterism
