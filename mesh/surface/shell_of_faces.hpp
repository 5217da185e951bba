// SPDX-License-Identifier: MIT
//
// Joins the plane meshes of patches to one shell in space.
#pragma once

#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface/curve_division.hpp"

namespace asterism::internal {

// Lifts the sites of each face. Those at common sides, corners, and sides that are one point become
// one vertex.
surface_shell shell_of_faces(const surface& s, const patch_faces& of);

}  // namespace asterism::internal
