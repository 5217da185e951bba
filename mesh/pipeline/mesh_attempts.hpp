// SPDX-License-Identifier: MIT
//
// Makes the attempts at a mesh of a domain in a metric, one after the other, and chooses the mesh
// that is shown.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/stars/star_confirmation.hpp"

namespace asterism::internal {

// Makes the mesh of make_mesh(). With by_auditor the last test of every star is left to the audit.
// In rare cases that refuses a complete outcome for a star; the call must then be repeated with
// by_mesher. Without `may_deliver` no attempt delivers another metric: so it is if none led to a
// mesh before.
result<mesh_outcome> make_by_attempts(const domain& d, const metric_field& field,
                                      const mesh_options& options,
                                      const progress_listener& progress,
                                      star_confirmation confirmed, bool may_deliver = true);

}  // namespace asterism::internal
