// SPDX-License-Identifier: MIT
//
// Makes a mesh whose stars were not all held against all sites: the auditor will do that.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// Does what make_mesh does, but for the last look at every star (stars/star_confirmation.hpp). A
// complete outcome is one that the audit may refuse for a star, if rarely; make_mesh is then to be
// called.
result<mesh_outcome> make_unconfirmed_mesh(const domain& d, const metric_field& field,
                                           const mesh_options& options,
                                           const progress_listener& progress);

}  // namespace asterism::internal
