// SPDX-License-Identifier: MIT
//
// Renders files of solutions for commands that write several files at once.
#pragma once

#include <filesystem>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism::internal {

// Returns the solution as read_solution does, but also accepts a file without fields, or with a
// single tensor.
result<solution> read_fields(const std::filesystem::path& path, const mesh& m,
                             const std::vector<vertex_index>& left_out);

// Checks that a solution could be written there: the extension, the folder, the place.
result<std::filesystem::path> check_solution_output(const std::filesystem::path& path);

// Returns the contents of the file for the extension.
std::string solution_text(const std::filesystem::path& path, const solution& s);

}  // namespace asterism::internal
