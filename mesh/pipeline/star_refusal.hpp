// SPDX-License-Identifier: MIT
//
// Decides whether an audit refuses a mesh for a star that its mesher had left to the audit.
#pragma once

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/stars/star_confirmation.hpp"

namespace asterism::internal {

// True if the mesher reported a complete mesh in the wanted metric, and the audit refuses one of
// its stars. A mesher that confirms its stars itself would have found that star before the audit.
bool is_refused_for_a_star(const mesh_outcome& outcome, const audit_report& report,
                           const mesh_options& options);

// Makes and audits a mesh whose stars only the audit confirms, and, if it refuses one of them,
// another mesh whose mesher confirms them. judged(confirmed, may_deliver) returns a
// result<certified_mesh>. Attempts at a delivered metric that led to no mesh are not repeated,
// except with a tolerance: the mesh delivered beyond it may be the only one to show.
template <class Judged>
auto judged_until_confirmed(const mesh_options& options, const Judged& judged) {
  auto made = judged(star_confirmation::by_auditor, true);
  if (!made || !is_refused_for_a_star(made.value().outcome, made.value().report, options))
    return made;
  return judged(star_confirmation::by_mesher, options.metric_tolerance.has_value());
}

}  // namespace asterism::internal
