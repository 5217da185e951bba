// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/make_mesh.hpp"

#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/pipeline/adaptation.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/metric_relaxation.hpp"
#include "asterism/mesh/refine/refinement_loop.hpp"

namespace asterism {
using namespace internal;

result<mesh_outcome> make_mesh(const domain& d, const metric_field& field,
                               const mesh_options& options,
                               const std::function<void(const mesh_progress&)>& progress) {
  if (wants_adaptation(field, options))
    if (auto adapted = adapt_mesh(d, field, options)) return *std::move(adapted);
  const filtered_kernel kernel;
  const star_predicates_on<filtered_kernel> stars_on(kernel);
  auto outcome = mesh_domain(stars_on, d, field, options, progress);
  if (!outcome) return outcome;
  if (wants_relaxation(outcome.value(), options))
    outcome = refine_relaxed(stars_on, d, field, options, progress, std::move(outcome).value());
  if (!outcome) return outcome;
  outcome.value().counters = stars_on.counters();
  assign_regions(outcome.value().result, d);
  return outcome;
}

}  // namespace asterism
