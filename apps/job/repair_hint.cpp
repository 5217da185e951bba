// SPDX-License-Identifier: MIT
#include "asterism/apps/job/repair_hint.hpp"

#include "asterism/apps/text/summary.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::apps {

repair_hint try_repair(const domain& refused) {
  constexpr double units = 2e4;  // of kernels/work_units.hpp, ten microseconds each
  const cancellation bounded = cancellation().with_work(units);
  domain_repairs repairs;
  if (repair_domain(refused, {}, &repairs, bounded))
    return {repair_answer::mends, text_of(repairs)};
  return {bounded.is_requested() ? repair_answer::not_known : repair_answer::fails, {}};
}

}  // namespace asterism::apps
