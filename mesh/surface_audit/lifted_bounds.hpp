// SPDX-License-Identifier: MIT
//
// Looks at parts of a shell's triangles: how far each is from its part of the surface, and how much
// the normals differ. In a floating_point_scope(rounding::upward).
#pragma once

#include "asterism/mesh/surface_audit/lifted_cells.hpp"

namespace asterism::internal {

// Sets the squared distances: `above` bounds that of every point of the part of the surface from
// the mesh.
void look_at_distance(const lifted_scene& scene, lifted_cell& cell, const triangle_net& net);

// Sets squares of tangents of the angle between the triangle's normal and the surface's. `above` is
// infinite where (r_u x r_v).n_T is not certainly positive on all of the part. `below` is -1 where
// it is not positive in the middle, in doubles.
void look_at_normals(const lifted_scene& scene, lifted_cell& cell, const triangle_net& net);

// Returns an upper bound of the squared distance of a vertex from the surface at (u, v) of a face.
double squared_vertex_distance(const lifted_scene& scene, std::uint32_t face, double u, double v,
                               const space_point& vertex);

}  // namespace asterism::internal
