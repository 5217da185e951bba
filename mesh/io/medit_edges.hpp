// SPDX-License-Identifier: MIT
//
// Decides which edges of a mesh file are segments of a domain.
//
// Edges are a set: their order and direction mean nothing. One with a triangle on one side alone is
// of the boundary. One with triangles on both is a segment only if the file marks it: by
// RequiredEdges, by different references of the two triangles, or by a reference other than 0 in a
// list that does not hold every inner edge. Some programs save all edges of a mesh; the edges of
// such a list are no segments.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"

namespace asterism::internal {

struct edge_marks {
  std::vector<char> required;  // one flag an edge of mesh::boundary
  bool all = false;            // every edge listed is a segment
};

// Turns the edges of `m.boundary` so that a triangle is on their left, notes those that are
// internal, and leaves out inner edges that are no segments. `sides` are the mesh's.
void keep_segments(mesh& m, const triangle_sides& sides, const edge_marks& marks);

// Adds the edges with one triangle that are not listed, with marker 0, and notes it: gmsh saves the
// lines of physical groups alone, and mmg's examples list the outer sides and no hole's. An empty
// list stays empty: adopt_mesh then finds all sides.
void list_sides(mesh& m, const triangle_sides& sides);

// Returns the marker of a boundary subsegment at each vertex, 0 for vertices on none: the
// references of vertices in the file.
std::vector<int> vertex_references(const mesh& m);

}  // namespace asterism::internal
