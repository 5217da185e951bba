// SPDX-License-Identifier: MIT
//
// Tells whether an audit refuses a mesh for a star that its mesher had left to the audit.
#pragma once

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/stars/star_confirmation.hpp"

namespace asterism::internal {

// True if the mesher took the mesh, in the metric wanted, to be complete, and the audit refuses one
// of its stars: a mesher that confirms its stars may find that before.
bool is_refused_for_a_star(const mesh_outcome& outcome, const audit_report& report,
                           const mesh_options& options);

// Makes and judges a mesh whose stars the audit alone has confirmed, and, where it refuses one of
// them, another whose mesher confirmed them. judged(confirmed, may_deliver) returns a
// result<certified_mesh>. Ways to a metric delivered that did not lead to a mesh are not gone
// again, but with a tolerance: the mesh that was delivered beyond it may be what there is to show.
template <class Judged>
auto judged_until_confirmed(const mesh_options& options, const Judged& judged) {
  auto made = judged(star_confirmation::by_auditor, true);
  if (!made || !is_refused_for_a_star(made.value().outcome, made.value().report, options))
    return made;
  return judged(star_confirmation::by_mesher, options.metric_tolerance.has_value());
}

}  // namespace asterism::internal
