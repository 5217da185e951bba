// SPDX-License-Identifier: MIT
//
// Reads meshes in space in formats that are not of simulation: .obj, .stl and .ply.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

// Reads a mesh from text; `file` is the name for messages.
result<space_mesh> parse_obj(std::string_view text, const std::string& file);
result<space_mesh> parse_stl(std::string_view bytes, const std::string& file);
result<space_mesh> parse_ply(std::string_view bytes, const std::string& file);

}  // namespace asterism::internal
