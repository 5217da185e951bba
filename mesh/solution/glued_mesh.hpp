// SPDX-License-Identifier: MIT
//
// A mesh continued across its boundary, and the metric of periodic functions on it.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"

namespace asterism::internal {

// A mesh, and copies of some of its triangles where it goes on for periodic functions.
struct glued_mesh {
  mesh continued;                    // the first vertices and triangles are the mesh's own
  std::vector<vertex_index> origin;  // of each vertex, the own one that has its value
  // Own vertices that are one place: in this order, what the first has the second gets.
  std::vector<std::array<vertex_index, 2>> partners;
};

// Makes the metric as make_solution_metric() does, of second derivatives that are recovered on the
// continued mesh. Partners have the same, bit for bit; gradation, which knows nothing of the
// copies, may part their tensors.
result<solution_metric> make_glued_metric(
    const mesh& m, const glued_mesh& glued, const std::vector<nodal_values>& fields,
    const solution_metric_options& options,
    const std::vector<std::vector<metric_tensor>>& intersected = {});

}  // namespace asterism::internal
