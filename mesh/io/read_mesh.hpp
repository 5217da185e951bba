// SPDX-License-Identifier: MIT
//
// Reads a mesh in the format that the extension names: .msh (and .msh2) by mesh/io/gmsh.hpp, .vtu
// by mesh/io/vtu_mesh.hpp, anything else as Medit's .mesh (mesh/io/medit.hpp).
#pragma once

#include <filesystem>
#include <string_view>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/io/medit.hpp"
#include "asterism/mesh/io/physical_names.hpp"

namespace asterism {

// True if a file of this name is a mesh: .mesh, .meshb, .msh, .msh2 or .vtu.
ASTERISM_EXPORT bool is_mesh_file(std::string_view name);

// Reads a mesh with its metric. A .msh or .vtu file has its own, as data at its nodes; the options
// about a .sol mean that for it, and options.solution is an error.
ASTERISM_EXPORT result<mesh> read_mesh(const std::filesystem::path& path,
                                       const medit_read_options& options = {});

// Returns what the file says must stay. Formats other than Medit's say nothing of it.
ASTERISM_EXPORT result<mesh_marks> read_mesh_marks(const std::filesystem::path& path);

// Returns the names that a .msh file gives to markers and regions; of other files none. Empty, too,
// where the file cannot be read.
ASTERISM_EXPORT physical_names names_in(const std::filesystem::path& path);

}  // namespace asterism
