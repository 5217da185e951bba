// SPDX-License-Identifier: MIT
//
// Meshes a domain in one metric for all sites. In it stars agree whatever sites there are
// (docs/math/delivered-metric.md): the last resort where nothing else has led to agreement.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/metric/background_metric.hpp"

namespace asterism::internal {

// Returns the mean of the metric wanted, scaled to the same complexity; none where that is no
// metric in doubles. `start` is any triangulation of the domain.
std::optional<metric_tensor> one_metric_for(const background_metric& wanted, const mesh& start);

// Mesh in one metric, and the length of its edges in it as a multiple of one.
struct mesh_of_one_metric {
  mesh made;
  double length_factor = 1;
};

// Refines the domain in that metric, for the angle bound and for about `count` vertices. Returns
// none where the demands are not met, or stars are left that do not agree because a limit on sites
// or work was met.
std::optional<mesh_of_one_metric> mesh_in_one_metric(const domain& shape,
                                                     const metric_tensor& metric,
                                                     const mesh_options& options,
                                                     std::size_t count);

}  // namespace asterism::internal
