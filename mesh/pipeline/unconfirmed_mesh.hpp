// SPDX-License-Identifier: MIT
//
// Makes a mesh whose stars were not all held against all sites: the auditor will do that.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::internal {

// Does what make_mesh does, but for the last look at every star (stars/star_confirmation.hpp). A
// complete outcome is one that the audit may refuse for a star, if rarely; make_mesh is then to be
// called.
result<mesh_outcome> make_unconfirmed_mesh(const domain& d, const metric_field& field,
                                           const mesh_options& options,
                                           const progress_listener& progress);

// True if the mesher took the mesh, in the metric wanted, to be complete, and the audit refuses one
// of its stars: make_mesh itself may find that before.
bool may_be_confirmed(const certified_mesh& judged, const mesh_options& options);

// Makes the mesh of make_mesh() where make_unconfirmed_mesh() led to one in the metric wanted: ways
// to a metric delivered that did not lead to a mesh then are not gone again.
result<mesh_outcome> make_confirmed_mesh(const domain& d, const metric_field& field,
                                         const mesh_options& options,
                                         const progress_listener& progress = {});

}  // namespace asterism::internal
