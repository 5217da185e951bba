// SPDX-License-Identifier: MIT
//
// Finds the domain that a mesh is of, with as few vertices as keep it: for adaptation loops, in
// which a mesh's own vertices must be free to go.
//
// Vertices of the domain: corners and required vertices, ends of required edges, where not two
// segments meet, where the marker changes or a segment becomes internal, and where the boundary
// turns by more than the angle. The segments between them are
//   - straight, where all vertices between are on the line up to sixteen units in the last place,
//     which then go;
//   - else, pieces of the polygon: of its vertices those stay that keep every piece at most one
//     long, as its ends' metric measures it, and no dropped one farther than a hundredth of the
//     piece from it. So a curved boundary follows the polygon, coarser where the metric is. Lines
//     between different regions keep every vertex that is not on a straight part.
// If that is no domain (check_domain), or the area of a region differs from the mesh's, curved
// parts keep all their vertices; where that does not do either, every vertex is one of the domain.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"

namespace asterism {

// A domain, and how it was found.
struct mesh_outline {
  domain shape;                       // as check_domain accepts it
  std::size_t boundary_vertices = 0;  // of the mesh
  std::size_t kept = 0;               // of those
  double greatest_distance = 0;       // of a dropped vertex from its segment
  bool keeps_all = false;             // every vertex of the mesh is one of the domain
  // The segment of each boundary edge of the mesh, where the first vertices of the mesh are those
  // of the domain in their order; else empty.
  std::vector<vertex_index> segment_of_edge;
};

// Returns the domain. The mesh must be a triangulation in order (adopt_mesh), with the metric in
// which pieces of curves are measured; 0 < corner_angle <= 180, degrees.
ASTERISM_EXPORT result<mesh_outline> outline_of_mesh(const mesh& m, const mesh_marks& marks,
                                                     double corner_angle);

}  // namespace asterism
