// SPDX-License-Identifier: MIT
//
// Finds the triangle of one mesh in which each vertex of another one lies.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

struct located_vertices {
  std::vector<vertex_index> triangle;  // of the mesh searched
  std::size_t outside = 0;             // vertices that are in none: theirs is near
  double greatest_distance = 0;        // of those from it
};

// Each vertex gets a closed triangle that contains it, by exact orientations: found by a walk from
// its neighbour on a space-filling curve, or by the boxes of triangles where the walk meets the
// boundary. A vertex may be in no triangle because of rounding, or because the boundaries differ.
// It gets the triangle of a neighbour in its own mesh, or a nearer one joined to that by edges, so
// none across a gap. A vertex of the boundary is on the side on which its own triangles are, where
// a slit has two sides in one place. Fails where no neighbour, however far, is in a triangle.
result<located_vertices> locate_vertices(const mesh& in, const mesh_links& links, const mesh& of,
                                         const mesh_links& of_links);

}  // namespace asterism::internal
