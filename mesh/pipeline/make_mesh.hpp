// SPDX-License-Identifier: MIT
//
// Makes a mesh of a domain in a metric field, without an audit; pipeline/certified_mesh.hpp makes
// and audits one.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism {

// Makes the mesh. `d` must have been accepted by check_domain. Fails only where the metric field
// does, or for options out of range. `progress` may be empty.
ASTERISM_EXPORT result<mesh_outcome> make_mesh(const domain& d, const metric_field& field,
                                               const mesh_options& options,
                                               const progress_listener& progress = {});

}  // namespace asterism
