// SPDX-License-Identifier: MIT
//
// Tells whether an audit refuses a mesh for a star that its mesher had left to the audit.
#pragma once

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism::internal {

// True if the mesher took the mesh, in the metric wanted, to be complete, and the audit refuses one
// of its stars: a mesher that confirms its stars may find that before.
bool is_refused_for_a_star(const mesh_outcome& outcome, const audit_report& report,
                           const mesh_options& options);

}  // namespace asterism::internal
