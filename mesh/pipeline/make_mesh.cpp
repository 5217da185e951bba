// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/make_mesh.hpp"

#include <algorithm>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/pipeline/adaptation.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/metric_relaxation.hpp"
#include "asterism/mesh/pipeline/unit_image.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"

namespace asterism {
using namespace internal;
namespace {

result<mesh_outcome> make_or_stop(const domain& d, const metric_field& field,
                                  const mesh_options& options, const progress_listener& progress) {
  if (auto refused = check_options(d, options)) return *refused;
  metric_delivery delivery(d, field, options);
  const bool is_first = may_adapt(options) && delivery.is_first_choice();
  const bool is_second = may_adapt(options) && !is_first;
  if (is_first)
    if (auto made = delivery.make(0)) return *std::move(made);
  // Little is spent on finding out that a mesh is not likely, the metric varying too fast.
  constexpr double little = 0.1;
  const double work_share = is_second && delivery.varies_fast() ? little : 1;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const unit_image image(d, field, options);
  auto outcome =
      mesh_domain({stars_on, image.shape(), image.field(), options, progress, work_share});
  if (!outcome) return outcome;
  image.outward(outcome.value());
  if (wants_relaxation(outcome.value(), options)) {
    constexpr std::size_t fewest = 400, most = 2000;
    const std::size_t few = std::clamp(outcome.value().sites, fewest, most);
    if (is_second)
      if (auto made = delivery.make(few)) return *std::move(made);
    outcome = refine_relaxed({stars_on, d, field, options, progress}, std::move(outcome).value());
  }
  if (!outcome) return outcome;
  outcome.value().counters = decided;
  assign_regions(outcome.value().result, d);
  return outcome;
}

// Says of a mesh whose improvement was cut short by a limit or an interrupt that it was. It would
// pass for the mesh of the whole run otherwise, which is another one.
void note_stop(const cancellation& stop, mesh_outcome& made) {
  if (!made.complete) return;
  const auto why = stop.poll();
  if (!why) return;
  made.complete = false;
  made.ended.how = ending::stopped;
  made.ended.stopped_because = *why + ", while a mesh without faults was being improved";
}

}  // namespace

result<mesh_outcome> make_mesh(const domain& d, const metric_field& field,
                               const mesh_options& options, const progress_listener& progress) {
  auto outcome = make_or_stop(d, field, options, progress);
  if (outcome) note_stop(options.stop, outcome.value());
  return outcome;
}

}  // namespace asterism
