// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/theorem_hypotheses.hpp"

#include "asterism/mesh/audit/theorem_of_mesh.hpp"

namespace asterism {

theorem_hypotheses measure_theorem_hypotheses(const mesh& subject, double angle_bound,
                                              const cancellation& stop) {
  return internal::theorem_of_mesh(subject, angle_bound, stop);
}

bool is_unmeasured(const theorem_hypotheses& h) {
  return h.reason.starts_with(internal::not_all_measured) && !h.applies;
}

}  // namespace asterism
