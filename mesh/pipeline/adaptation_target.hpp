// SPDX-License-Identifier: MIT
//
// Sets the number of vertices that an adapted mesh is to have, and judges whether the outcome is
// what was asked for: the same for the command and for Python.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/pipeline/adapt_to_metric.hpp"
#include "asterism/mesh/solution/solution_metric.hpp"

namespace asterism::internal {

// The metric asked for in an adaptation, and the report of the metric made.
struct adaptation_wish {
  const solution_metric_options& wishes;
  const solution_metric_report& report;
  std::size_t vertices_before = 0;  // of the mesh given
  bool of_solution = false;         // the metric is a solution's
};

// Sets the number of vertices if the wish names one, and the limit on sites if it asks for an error
// or complexity. A target that was not met leaves the number to the metric. Refuses numbers beyond
// the default limit on sites: the run would be long, and end with another mesh. `limit` is the name
// of the option that raises it.
ASTERISM_EXPORT std::optional<error> take_target(const adaptation_wish& wish,
                                                 const std::string& limit,
                                                 mesh_adaptation_options& options);

// Returns a sentence on what was not reached: the mesh, the metric's target, or the number of
// vertices. That number may be off by a tenth, or by five if that is more; where fewer than ten are
// wanted, by half of them. Returns nothing where all was reached.
ASTERISM_EXPORT std::optional<std::string> what_is_missed(
    const adapted_mesh& next, const solution_metric_report& report,
    const std::optional<std::size_t>& vertices_wanted);

}  // namespace asterism::internal
