// SPDX-License-Identifier: MIT
//
// Reads second derivatives from a file: symmetric tensors at the vertices of a mesh, of either
// sign.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"

namespace asterism::internal {

// Second derivatives as read, with the reader's notes.
struct given_hessians {
  std::vector<nodal_hessian> fields;
  std::vector<std::string> notes = {};
};

// Returns the tensors of a file in one of the formats of solutions (mesh/io/solution_file.hpp), all
// or those with these names. `left_out` is as for read_solution. Fails where there are none, and
// for names that are missing or not of tensors.
result<given_hessians> read_hessians(const std::string& file, const mesh& m,
                                     const std::vector<vertex_index>& left_out,
                                     const std::vector<std::string>& names);

}  // namespace asterism::internal
