// SPDX-License-Identifier: MIT
//
// Decides whether a metric delivered is near enough to the one wanted for a run to be complete.
// Internal to mesh/pipeline.
#pragma once

#include <optional>

#include "asterism/mesh/data/delivered_report.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Returns the distance of the delivered metric from the one wanted if it exceeds the tolerance;
// none where it does not, where no other metric is delivered, or where the run was stopped. Without
// a tolerance, bounds on the median over sites and on the ratio of densities count.
std::optional<intolerable_distance> excess_of(const mesh_outcome& made,
                                              const mesh_options& options);

// Returns the distance if it exceeds the tolerance, for distances that were measured before.
// Without a tolerance the bounds of excess_of() apply.
std::optional<intolerable_distance> excess_in(const delivered_report& report,
                                              std::optional<double> tolerance);

}  // namespace asterism::internal
