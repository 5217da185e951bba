// SPDX-License-Identifier: MIT
//
// Adds a sentence about the mesh to a file, as a comment.
#pragma once

#include <string>

#include "asterism/mesh/io/mesh_format.hpp"

namespace asterism::internal {

// Returns `contents`, the file or its beginning, with the note as a comment after its first line,
// which .mesh, .vtu and .svg require as it is; unchanged where the note is empty.
std::string with_file_note(std::string contents, mesh_format format, const std::string& note);

}  // namespace asterism::internal
