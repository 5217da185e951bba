// SPDX-License-Identifier: MIT
//
// Makes a mesh of a metric that is scaled until as many vertices come out as are wanted.
#pragma once

#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/pipeline/periodic_mesh.hpp"
#include "asterism/mesh/pipeline/scaled_metric.hpp"

namespace asterism {

// A mesh, and the metric it was asked for in.
struct counted_mesh {
  certified_mesh made;
  scaled_metric metric;
};

// Scales the metric as `scale` says and makes a mesh in it, as make_scaled_metric and
// make_certified_mesh do, whose failures are its own. With options.vertices the metric is scaled
// to these, whatever size or complexity `scale` names; if the mesh is certified and has over 5 %
// more or fewer, it is made again with the metric scaled to other numbers, ten times at most and
// with a third of the work of a run, and the nearest that is certified is returned. A number may
// lie below what the domain takes, or between two that come out: then none is near. With pairs each
// mesh is one of make_periodic_mesh.
ASTERISM_EXPORT result<counted_mesh> make_counted_mesh(
    const domain& d, const field_of_size& make, const scale_demand& scale,
    const mesh_options& options, const progress_listener& progress = {},
    const std::vector<periodic_pair>& pairs = {});

}  // namespace asterism
