// SPDX-License-Identifier: MIT
//
// Computes second derivatives of fields, from which their metric is made.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/solution/glued_mesh.hpp"
#include "asterism/mesh/solution/hessian.hpp"
#include "asterism/mesh/solution/solution_metric_options.hpp"

namespace asterism::internal {

// Second derivatives of the fields in the order of their names: as recovered, and as means of
// moduli, from which the metric is made.
struct field_derivatives {
  std::vector<std::string> names;
  std::vector<std::vector<metric_tensor>> recovered, moduli;
  // Each field was divided by 2 to its power before: 0 but for values so large or so small that
  // products of their second derivatives have no double.
  std::vector<int> powers;
  std::vector<std::vector<double>> scales;  // of a relative error; none for one that is not
  std::size_t noise = 0, at_boundary = 0;
  // Bounds on aspects that fields ask for (mesh/solution/computed_field.hpp); none where second
  // derivatives or an aspect are given.
  std::vector<std::optional<double>> aspects;
};

// Recovers second derivatives from values at the vertices, by the options; on the continued mesh if
// there is one.
result<field_derivatives> recovered_derivatives(const mesh& m, const mesh_links& links,
                                                const std::vector<nodal_values>& fields,
                                                const solution_metric_options& options,
                                                const glued_mesh* glued = nullptr);

// Takes second derivatives as they are given. The optimum needs only their moduli. Fails for a
// field of another number of vertices.
result<field_derivatives> given_derivatives(const mesh& m,
                                            const std::vector<nodal_hessian>& fields);

}  // namespace asterism::internal
