// SPDX-License-Identifier: MIT
//
// Bounds how much the normals of parts of a shell's triangles differ from the surface's. Requires a
// floating_point_scope(rounding::upward).
#pragma once

#include "asterism/mesh/surface_audit/lifted_cells.hpp"

namespace asterism::internal {

// Sets squares of tangents of the angle between the triangle's normal and the surface's. `above` is
// infinite where (r_u x r_v).n_T is not certainly positive on all of the part. `below` is -1 where
// it is not positive in the middle, in doubles.
void look_at_normals(const lifted_scene& scene, lifted_cell& cell, const triangle_net& net);

}  // namespace asterism::internal
