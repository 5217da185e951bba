// SPDX-License-Identifier: MIT
//
// Reads the point data of a .vtu file (mesh/io/solution_file.hpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism::internal {

// `file` is its name, for messages.
result<solution> read_vtu_solution(std::string_view text, const std::string& file, const mesh& m,
                                   const std::vector<vertex_index>& left_out);

}  // namespace asterism::internal
