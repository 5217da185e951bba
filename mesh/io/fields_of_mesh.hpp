// SPDX-License-Identifier: MIT
//
// Finds the fields in the file of a mesh, or beside it.
#pragma once

#include <filesystem>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/io/read_mesh.hpp"

namespace asterism::internal {

// Returns the fields at the vertices of a mesh that was read from this file: node data of a .msh,
// point data of a .vtu, for a .mesh the fields of NAME.sol beside it, if that is no metric, and of
// NAME.fields.sol. Succeeds without any fields.
result<solution> fields_of_mesh(const std::filesystem::path& path, const mesh_file& read);

}  // namespace asterism::internal
