// SPDX-License-Identifier: MIT
//
// Reads triangle meshes in space: .obj, .stl (text and binary), .ply (text and binary), Medit's
// .mesh as text, gmsh's .msh 2.2 and 4.1 as text, and .vtu.
//
// Corners of .stl files that are equal become one vertex; in other formats vertices stay as they
// are. Polygons of .obj and .ply become fans of triangles, with a note. Points, lines, materials
// and normals are ignored. Other cells are an error.
#pragma once

#include <filesystem>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

// True if a file with this name may be a mesh in space.
bool is_space_mesh_file(std::string_view name);

result<space_mesh> read_space_mesh(const std::filesystem::path& path);

}  // namespace asterism::internal
