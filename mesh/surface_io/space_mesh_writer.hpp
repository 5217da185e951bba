// SPDX-License-Identifier: MIT
//
// Writes meshes in space.
#pragma once

#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

// Returns the content of a file in the format of the name's ending: .obj, .stl and .ply as text,
// Medit's .mesh, gmsh's .msh 2.2, .vtu. Doubles read back the same. The face of a triangle is its
// reference in .mesh, its physical group in .msh, and a number of the cell in .vtu.
result<std::string> space_mesh_text(const space_mesh& m, const std::string& file);

}  // namespace asterism::internal
