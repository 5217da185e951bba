// SPDX-License-Identifier: MIT
//
// Makes a mesh by local changes, in a metric as near to the one wanted as stars can agree about
// (docs/design/adaptation.md). The metric delivered is reported.
//
// Stars disagree where tensors turn or change by much over an edge, whatever sites there are. The
// metric of a site is its own, however. It is changed where that is needed, as little as will do,
// and the outcome says by how much. The mesh is certified in the metric delivered.
#pragma once

#include <optional>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// True if the run is one for adapt_mesh: the metric is given at the vertices of a mesh, with a
// size, may be relaxed, and the domain is not a mesh that may stay as it is.
bool wants_adaptation(const metric_field& field, const mesh_options& options);

// Makes everything of the outcome but the counters. Returns none where this way did not lead to a
// certified mesh and was not stopped, and some other should be tried.
std::optional<mesh_outcome> adapt_mesh(const domain& d, const metric_field& field,
                                       const mesh_options& options);

}  // namespace asterism::internal
