// SPDX-License-Identifier: MIT
#include "asterism/mesh/mesher.hpp"

#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/mesh_regions.hpp"
#include "asterism/mesh/refinement.hpp"
#include "asterism/mesh/relaxation.hpp"

namespace asterism {

result<refinement_outcome> make_mesh(
    const domain& d, const metric_field& field, const refinement_options& options,
    const std::function<void(const refinement_progress&)>& progress) {
  const filtered_kernel kernel;
  const star_kernel_on<filtered_kernel> stars_on(kernel);
  auto outcome = refine_on(stars_on, d, field, options, progress);
  if (!outcome) return outcome;
  if (wants_relaxation(outcome.value(), options))
    outcome = refine_relaxed(stars_on, d, field, options, progress, std::move(outcome).value());
  if (!outcome) return outcome;
  outcome.value().counters = stars_on.counters();
  assign_regions(outcome.value().result, d);
  return outcome;
}

}  // namespace asterism
