// SPDX-License-Identifier: MIT
//
// Bounds how far parts of a shell's triangles are from their parts of the surface. Requires a
// floating_point_scope(rounding::upward).
#pragma once

#include "asterism/mesh/surface_audit/lifted_cells.hpp"

namespace asterism::internal {

// Sets the squared distances of the cell: `above` bounds that of every point of its part of the
// surface from the mesh; `below` is that of the part's middle, in doubles.
void look_at_distance(const lifted_scene& scene, lifted_cell& cell, const triangle_net& net);

// Returns an upper bound of the squared distance of a vertex from the surface at (u, v) of a face.
double squared_vertex_distance(const lifted_scene& scene, std::uint32_t face, double u, double v,
                               const space_point& vertex);

}  // namespace asterism::internal
