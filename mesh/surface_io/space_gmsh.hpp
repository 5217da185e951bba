// SPDX-License-Identifier: MIT
//
// Reads meshes in space of gmsh's .msh 2.2 and 4.1 as text.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

// Reads a mesh from text; `file` is the name for messages.
result<space_mesh> parse_space_gmsh(std::string_view text, const std::string& file);

}  // namespace asterism::internal
