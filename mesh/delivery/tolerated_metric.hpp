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
// none where it does not, where there is no other metric, or where the run was stopped. Without a
// tolerance the median over sites counts, and the density on the whole.
std::optional<intolerable_distance> excess_of(const mesh_outcome& made,
                                              const mesh_options& options);

// Returns the same of distances measured, with a tolerance or without.
std::optional<intolerable_distance> excess_in(const delivered_report& report,
                                              std::optional<double> tolerance);

}  // namespace asterism::internal
