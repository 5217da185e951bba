// SPDX-License-Identifier: MIT
#include "asterism/mesh/mesher.hpp"

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/mesh_regions.hpp"
#include "asterism/mesh/refinement.hpp"

namespace asterism {

result<refinement_outcome> make_mesh(
    const domain& d, const metric_field& field, const refinement_options& options,
    const std::function<void(const refinement_progress&)>& progress) {
  const filtered_kernel kernel;
  auto outcome = refine_on(star_kernel_on(kernel), d, field, options, progress);
  if (!outcome) return outcome;
  outcome.value().counters = kernel.counters();
  assign_regions(outcome.value().result, d);
  return outcome;
}

}  // namespace asterism
