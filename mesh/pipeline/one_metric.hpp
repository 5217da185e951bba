// SPDX-License-Identifier: MIT
//
// Meshes a domain in one metric for all sites. In it stars agree whatever sites there are
// (docs/math/delivered-metric.md): the last resort where nothing else has led to agreement.
#pragma once

#include <memory>
#include <optional>

#include "asterism/mesh/adapt/nodal_field.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Returns the mean of the metric wanted, made as dense on the whole; null where that is no metric
// in doubles. `start` is any triangulation of the domain.
std::unique_ptr<metric_field> one_metric_for(const adapting::nodal_field& wanted,
                                             const mesh& start);

// Refines the domain in that metric, for the angle bound and the size, or without demands. Returns
// none where stars are left that do not agree, because a limit on sites or work was met.
std::optional<mesh_outcome> mesh_in_one_metric(const domain& shape, const metric_field& metric,
                                               const mesh_options& options, bool has_demands);

}  // namespace asterism::internal
