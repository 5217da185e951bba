// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/star_refusal.hpp"

#include <cstddef>

namespace asterism::internal {

bool is_refused_for_a_star(const mesh_outcome& outcome, const audit_report& report,
                           const mesh_options& options) {
  if (!outcome.complete || outcome.delivered || outcome.one_metric || options.improve_passes > 0)
    return false;
  const auto found = [&](finding_kind kind) {
    return report.found[static_cast<std::size_t>(kind)] > 0;
  };
  return found(finding_kind::star_neighbour_rejected) || found(finding_kind::star_site_missing);
}

}  // namespace asterism::internal
