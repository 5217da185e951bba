// SPDX-License-Identifier: MIT
//
// Finds the format of a mesh by the name of its file, and the files of each format.
#pragma once

#include <filesystem>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/io/format_names.hpp"  // IWYU pragma: export

namespace asterism {

// Returns the format of the extension, in upper or lower case; the error lists the known
// ones.
ASTERISM_EXPORT result<mesh_format> mesh_format_of(const std::filesystem::path& path);

// Returns all files that are written with `path`, itself first.
ASTERISM_EXPORT std::vector<std::filesystem::path> files_of_output(
    const std::filesystem::path& path);

// True for .svg, .png and .pdf.
ASTERISM_EXPORT bool is_picture(mesh_format format);

// True if files of the format can hold triangles of second order.
ASTERISM_EXPORT bool holds_second_order(mesh_format format);

}  // namespace asterism
