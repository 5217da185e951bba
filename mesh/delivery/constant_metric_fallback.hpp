// SPDX-License-Identifier: MIT
//
// Makes a mesh on which all stars agree where no other attempt led to one.
//
// Stars disagree at any distance of sites where a metric jumps, or turns by much over one edge
// (docs/math/refinement.md). A site's metric is its own, however: if no change of single sites'
// metrics led to a mesh (delivery/metric_delivery.hpp), one metric is given to all sites, in which
// stars agree whatever the sites (docs/math/delivered-metric.md):
//  1. the log-Euclidean mean of the tensors at the present sites, with the demands;
//  2. the same without demands on angles and sizes, which is never called complete.
//
// Before that, a delivery by local changes that led to no certified mesh tries one metric as well,
// for a given number of sites and with the demands, and then restores wanted tensors.
//
// The mesh is certified in that metric, and how far it is from the one wanted is reported. Step 2
// may end without agreement where a limit on sites or work is met; then the outcome is the one in
// the metric given.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

// True if `made`, in the metric given, is no mesh: some of its triangles disagree, or it has only
// the given sites because no others could be spread.
bool wants_other_metric(const mesh_outcome& made, const mesh_options& options);

// Makes everything of the outcome but the counters, which the kernel has. Requires
// wants_other_metric(as_given, job.options). The job's domain and field, and `as_given`, are in the
// caller's units. Fails where the field fails at a site of the mesh.
result<mesh_outcome> refine_in_one_metric(const meshing_context& job, mesh_outcome as_given);

// Returns the mean of the metric wanted, scaled to the same complexity; none where that is no
// metric in doubles. `start` is any triangulation of the domain.
std::optional<metric_tensor> one_metric_for(const background_metric& wanted, const mesh& start);

// A mesh in one metric for all sites, and the length of its edges in that metric.
struct mesh_of_one_metric {
  mesh made;
  double length_factor = 1;
};

// Refines the domain in that metric, for the angle bound and for about `count` vertices. Returns
// none where the demands are not met, or where stars disagree because a limit on sites or work was
// met.
std::optional<mesh_of_one_metric> mesh_in_one_metric(const domain& shape,
                                                     const metric_tensor& metric,
                                                     const mesh_options& options,
                                                     std::size_t count);

}  // namespace asterism::internal
