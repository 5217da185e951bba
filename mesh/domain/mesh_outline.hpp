// SPDX-License-Identifier: MIT
//
// Finds the domain that a mesh covers, with as few vertices as possible: for adaptation loops, in
// which a mesh's own vertices may be removed.
//
// Vertices of the domain are: corners and required vertices, ends of required edges, and vertices
// where not exactly two segments meet, where the marker changes or a segment becomes internal, and
// where the boundary turns by more than the angle. The segments between them are
//   - straight, if all vertices between are on the line up to sixteen units in the last place;
//     these vertices are removed;
//   - else, pieces of the polygon: vertices of it are removed as long as every piece has at most
//     length 1 in the metric of its ends, and no removed vertex is farther from its piece than is
//     allowed: without a distance, a part of the piece's length, and of the metric's size across
//     it.
//     So a curved boundary follows the polygon, with longer pieces where the metric is coarser. The
//     part of the length matters where edges wanted are longer than that: the vertices that stay
//     are in the next mesh, and many short pieces leave no room for triangles whose angles meet the
//     bound. A side that stays a polygon has no cubics.
//     Lines between different regions keep every vertex that is not on a straight part. A piece of
//     the outer boundary is a cubic through its ends (outline_curves.hpp), on which the next mesh
//     splits it; it is straight if the cubic would be farther from the polygon than is allowed, or
//     would come too near to other pieces.
// If the result is no domain (check_domain), or the area of a region differs from the mesh's by
// more than removals within the distance allowed can explain, curved parts keep all their vertices;
// if that fails, too, every vertex of the mesh is one of the domain.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/former_boundary.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"

namespace asterism {

// Demands on the domain.
struct outline_options {
  double corner_angle = 30;  // degrees, above 0 and at most 180
  // Greatest distance of the boundary of the mesh from that of any mesh of the domain, both ways;
  // default: as described above. Must be at least 2^-40 of the largest coordinate, which exceeds
  // rounding errors.
  std::optional<double> largest_distance = {};
  std::vector<int> polygons = {};  // markers of sides that stay polygons
  // Without a largest distance, the distance allowed as a part of a piece's length, and of the
  // metric's size across it. Must be above 0 and at most 1/8. The part of the length was chosen by
  // experiment (bench/adapt/bent_sides.py).
  double part_of_length = 0.03, part_of_size = 0.01;
};

// The domain of a mesh, and how it was found.
struct mesh_outline {
  domain shape;                       // as check_domain accepts it
  former_boundary former;             // along its segments
  std::size_t boundary_vertices = 0;  // of the mesh
  std::size_t kept = 0;               // of those
  double greatest_distance = 0;       // of a dropped vertex from its segment
  bool keeps_all = false;             // every vertex of the mesh is one of the domain
  double part_of_size = 0.01;         // outline_options::part_of_size
  // Segment of the domain for each boundary edge of the mesh, if the first vertices of the mesh are
  // those of the domain in their order; else empty.
  std::vector<vertex_index> segment_of_edge;
};

// Returns the domain of a mesh. The mesh must be a triangulation in order (adopt_mesh), with the
// metric in which pieces of curves are measured.
ASTERISM_EXPORT result<mesh_outline> outline_of_mesh(const mesh& m, const mesh_marks& marks,
                                                     const outline_options& options);

}  // namespace asterism
