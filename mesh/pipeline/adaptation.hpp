// SPDX-License-Identifier: MIT
//
// A mesh made by local changes, in a metric that is delivered as near to the one wanted as stars
// can agree about (docs/design/adaptation.md).
//
// Where tensors turn or change by much over an edge, stars disagree whatever sites there are. The
// metric of a site is its own, however: it is changed where that is needed, as little as will do,
// and the outcome says by how much. What is certified is the mesh in the metric delivered.
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

// Everything of the outcome but the counters; none where this way did not lead to a certified mesh
// and was not stopped, and some other should be tried.
std::optional<mesh_outcome> adapt_mesh(const domain& d, const metric_field& field,
                                       const mesh_options& options);

}  // namespace asterism::internal
