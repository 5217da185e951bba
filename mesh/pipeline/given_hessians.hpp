// SPDX-License-Identifier: MIT
//
// Reads second derivatives that somebody else has: symmetric tensors at the vertices of a mesh, of
// either sign.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"

namespace asterism::internal {

// Returns the tensors of a file in one of the forms that solutions have
// (mesh/io/solution_file.hpp), or those with these names. `left_out` as read_solution has it. Fails
// where there is none, and for names that are not there or of something else.
result<std::vector<nodal_hessian>> read_hessians(const std::string& file, const mesh& m,
                                                 const std::vector<vertex_index>& left_out,
                                                 const std::vector<std::string>& names);

}  // namespace asterism::internal
