// SPDX-License-Identifier: MIT
//
// Makes a mesh to which the theorem on nets applies: makes edges shorter until it applies. Source:
// docs/math/guarantee.md, which states for which domains and fields this ends.
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism {

// Makes a mesh as make_certified_mesh does, with edges of length 1/k in the metric of `field`,
// where k is the first of 1, 1.3, 1.69, 2.197, ... for which the theorem on nets applies to a
// certified mesh with options.angle_bound; `claim.guarantee` says so then. The ladder begins where
// the field, as sampled, allows it. If the theorem applies to no mesh of at most options.max_sites
// sites, or the run was stopped, the last mesh is returned; it is not complete, and `claim.reason`
// says how far the run came.
//
// Fails as make_certified_mesh does. Fails, too, naming the hypothesis that does not hold, for an
// angle bound above 20 degrees, for a vertex with an angle below 36 degrees between segments, as
// its own metric measures it, and where the field was found to jump. Of `options` the strategy,
// tolerance, size limit, improvement and metric tolerance are replaced: sizes are limited, and no
// tensor is changed.
ASTERISM_EXPORT result<certified_mesh> make_guaranteed_mesh(const domain& d,
                                                            const metric_field& field,
                                                            const mesh_options& options,
                                                            const progress_listener& progress = {});

}  // namespace asterism
