// SPDX-License-Identifier: MIT
//
// Reads the node data of a gmsh file (mesh/io/gmsh.hpp) as a solution.
#pragma once

#include <string>
#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism::internal {

// Returns the node data with 1, 3 or 9 numbers a node, in the order in which the file lists its
// nodes: scalars, vectors of which the third component is 0, and symmetric tensors of the plane.
// Data named "metric" is the metric and no field. If a name occurs several times, as for steps in
// time, the last data counts, and a note says which step that is. Data with other numbers a node is
// skipped. Fails, naming the line, for numbers that are none or not finite, for nodes that do not
// exist, and for data that not every node has.
result<solution> read_gmsh_solution(std::string_view text, const std::string& file);

}  // namespace asterism::internal
