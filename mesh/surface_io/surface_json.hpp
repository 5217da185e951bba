// SPDX-License-Identifier: MIT
//
// Reads and writes surfaces as JSON (docs/manual/surfaces.md has the schema).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// Reads a surface. Errors have the form `file: patch N: ...`; bezier_pieces checks the numbers.
result<surface> parse_surface(std::string_view text, const std::string& file);
result<surface> read_surface(const std::filesystem::path& path);

// Returns a text that reads back to the same doubles.
std::string surface_text(const surface& s);

}  // namespace asterism::internal
