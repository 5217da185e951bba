// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/make_mesh.hpp"

#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/pipeline/adaptation.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/metric_relaxation.hpp"
#include "asterism/mesh/pipeline/unit_image.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism {
using namespace internal;

result<mesh_outcome> make_mesh(const domain& d, const metric_field& field,
                               const mesh_options& options, const progress_listener& progress) {
  if (wants_adaptation(field, options))
    if (auto adapted = adapt_mesh(d, field, options)) return *std::move(adapted);
  const star_predicates_on<filtered_kernel> stars_on;
  const unit_image image(d, field, options);
  auto outcome = mesh_domain({stars_on, image.shape(), image.field(), options, progress});
  if (!outcome) return outcome;
  image.outward(outcome.value());
  if (wants_relaxation(outcome.value(), options))
    outcome = refine_relaxed({stars_on, d, field, options, progress}, std::move(outcome).value());
  if (!outcome) return outcome;
  outcome.value().counters = stars_on.counters();
  assign_regions(outcome.value().result, d);
  return outcome;
}

}  // namespace asterism
