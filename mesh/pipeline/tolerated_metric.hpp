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

// Returns the distance of the metric delivered from the one wanted; none where that is near enough,
// where there is no other metric, or where the run was stopped. Without a tolerance what half of
// the sites find counts, and how dense the metric is on the whole.
std::optional<intolerable_distance> excess_of(const mesh_outcome& made,
                                              const mesh_options& options);

// The same of what was measured, with a tolerance or without.
std::optional<intolerable_distance> excess_in(const delivered_report& report,
                                              std::optional<double> tolerance);

}  // namespace asterism::internal
