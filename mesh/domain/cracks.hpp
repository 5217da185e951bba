// SPDX-License-Identifier: MIT
//
// Joins and parts slits and cracks: edges of a mesh whose vertices exist twice, once for the
// triangles on each side. Inside the mesher, and for the auditor, such an edge is a segment inside
// the domain with one vertex at each place. Files have the vertices of both sides.
//
// A vertex exists once for each fan of triangles around it that edges of cracks, and the boundary,
// separate from the others: once at the tip of a crack, twice along it, three times where three
// cracks meet.
#pragma once

#include <map>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// The markers of the two sides of a crack's edges.
struct crack_sides {
  int left = 0, right = 0;  // of the edge as it is directed
};

// Pairs of markers of cracks, by the marker that their edges have inside the mesher: every edge
// with such a marker is one of a crack. Empty if there are no cracks.
using crack_markers = std::map<int, crack_sides>;

// Cracks of a mesh that has one vertex at each place.
struct joined_cracks {
  crack_markers markers;
  std::vector<vertex_index> number;  // of each vertex there was; empty where all stay
  std::size_t joined = 0;            // vertices that went
};

// Joins vertices at one place where the triangles of both meet along edges: two boundary sides with
// the same ends, one from each side. The first vertex stays, with a metric at least as fine as the
// metrics of all. An edge is listed once, in the direction with the lesser marker on its left; its
// own marker is the common one of both sides, if no other edge has that, else a free one. Fails,
// naming the vertices, where vertices are at one place and no such edge is at it. Joins nothing if
// triangles or edges name missing vertices, which other checks report. A mesh that is refused stays
// as it is. Numbers in messages count from `first_number`.
ASTERISM_EXPORT result<joined_cracks> join_cracks(mesh& m, int first_number = 1);

// A mesh with the vertices of both sides.
struct parted_mesh {
  mesh content;
  // Number in the joined mesh of each vertex of the parted mesh; the first vertices have the same
  // numbers in both.
  std::vector<vertex_index> original;
};

// Parts the mesh along the edges of cracks: the cracks divide the triangles around a vertex into
// fans. The fan with the first triangle keeps the vertex; each other fan gets a copy, numbered
// after all vertices of the joined mesh. Each edge of a crack becomes two boundary edges: the left
// one in its place, the right one at the end of the list.
ASTERISM_EXPORT parted_mesh part_cracks(const mesh& joined, const crack_markers& cracks);

}  // namespace asterism
