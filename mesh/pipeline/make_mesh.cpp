// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/make_mesh.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/pipeline/adaptation.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/metric_relaxation.hpp"
#include "asterism/mesh/pipeline/unit_image.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism {
using namespace internal;
namespace {

// Distance of the metric delivered from the one wanted; none where that is near enough.
std::optional<intolerable_distance> excess_of(const mesh_outcome& made,
                                              const mesh_options& options) {
  if (!made.delivered || made.stopped) return std::nullopt;
  const bool is_median = !options.metric_tolerance;
  const double greatest = made.delivered->greatest;
  const double allowed = options.metric_tolerance.value_or(most_median_distance);
  const double found = is_median ? made.delivered->median : greatest;
  if (found <= allowed) return std::nullopt;
  return intolerable_distance{allowed, found, is_median, greatest};
}

// Returns the mesh delivered if it is what there is to show: near enough, or, where no tolerance is
// asked for, not complete but as near as was found.
std::optional<mesh_outcome> shown(std::optional<mesh_outcome>& delivered,
                                  const mesh_options& options) {
  if (!delivered) return std::nullopt;
  const auto excess = excess_of(*delivered, options);
  if (excess && !excess->is_median) return std::nullopt;
  if (excess) delivered->complete = false;
  delivered->intolerable = excess;
  return std::move(delivered);
}

// Chooses what there is to show where no metric that is near enough led to a mesh: with a tolerance
// of 0 the mesh of the metric wanted, in which not all stars agree, and else the mesh of a metric
// too far away, in which they do.
mesh_outcome mesh_beyond_tolerance(mesh_outcome as_given, mesh_outcome delivered,
                                   const mesh_options& options) {
  const auto found = excess_of(delivered, options);
  if (!found) return as_given;
  mesh_outcome& shown = found->allowed > 0 ? delivered : as_given;
  shown.intolerable = found;
  shown.complete = false;
  return std::move(shown);
}

bool has_one_metric(const mesh& m) {
  return std::all_of(m.sites.begin(), m.sites.end(),
                     [&m](const site& s) { return identical(s.metric, m.sites.front().metric); });
}

// True if stars disagree or angles are low, which another metric may mend; false where only the
// limit on sites made edges longer, or angles are low in one metric for all or beside sharp corners
// alone: then the domain or its size is in the way.
bool wants_delivery(const mesh_outcome& made, const mesh_options& options) {
  if (wants_relaxation(made, options)) return true;
  return !made.complete && !made.stopped && made.ended.how != ending::complete &&
         made.ended.how != ending::site_limit && made.ended.how != ending::collateral &&
         !has_one_metric(made.result);
}

// Returns the options with a part of the work that is left.
mesh_options with_part_of_work(const mesh_options& options, double share) {
  mesh_options limited = options;
  limited.stop = options.stop.part(share);
  return limited;
}

result<mesh_outcome> make_or_stop(const domain& d, const metric_field& field,
                                  const mesh_options& options, const progress_listener& progress) {
  if (auto refused = check_options(d, options)) return *refused;
  // Shares of the work of the run; what is left in the end is for one metric everywhere.
  constexpr double for_delivery = 0.65, for_metric_wanted = 0.6;
  mesh_options delivering = with_part_of_work(options, for_delivery);
  metric_delivery delivery(d, field, delivering);
  const bool is_first = may_adapt(options) && delivery.is_first_choice();
  const bool is_second = may_adapt(options) && !is_first;
  std::optional<mesh_outcome> delivered;
  if (is_first) {
    delivered = delivery.make(0);
    if (auto made = shown(delivered, options)) return *std::move(made);
  }
  // Little is spent on finding out that a mesh is not likely, the metric varying too fast, and not
  // much where there are other ways.
  constexpr double little = 0.1, less = 0.5;
  const bool is_strict = options.metric_tolerance == 0.0;
  const bool may_give_up = !is_strict && is_second;
  const bool tries_little = may_give_up && delivery.wants_few_sites();
  double work_share = may_adapt(options) ? less : 1;
  if (tries_little || (may_give_up && delivery.varies_fast())) work_share = little;
  mesh_options as_wanted = with_part_of_work(options, for_metric_wanted);
  as_wanted.relax = options.relax && !is_strict;
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  const unit_image image(d, field, options);
  const auto mesh_as_wanted = [&](double share) {
    return mesh_domain({stars_on, image.shape(), image.field(), as_wanted, progress, share});
  };
  auto outcome = mesh_as_wanted(work_share);
  if (!outcome) return outcome;
  if (tries_little && outcome.value().ended.how == ending::overworked && !delivery.varies_fast())
    outcome = mesh_as_wanted(less);
  if (!outcome) return outcome;
  image.outward(outcome.value());
  if (is_second && wants_delivery(outcome.value(), options)) {
    constexpr std::size_t fewest = 400, most = 2000;
    const std::size_t few = std::clamp(outcome.value().sites, fewest, most);
    delivering.stop = options.stop.part(for_delivery);
    delivered = delivery.make(std::min(few, options.max_sites / 2));
    if (auto made = shown(delivered, options)) return *std::move(made);
  }
  if (wants_relaxation(outcome.value(), options) && !options.metric_tolerance) {
    // Leaves curves out: without demands, chords stay straight.
    domain straight = d;
    straight.curves.clear();
    outcome =
        refine_relaxed({stars_on, straight, field, options, progress}, std::move(outcome).value());
  }
  if (!outcome) return outcome;
  if (delivered && !outcome.value().complete && !outcome.value().stopped)
    outcome = mesh_beyond_tolerance(std::move(outcome).value(), *std::move(delivered), options);
  outcome.value().counters = decided;
  assign_regions(outcome.value().result, d);
  return outcome;
}

// Says of a mesh whose improvement was cut short by a limit or an interrupt that it was. It would
// pass for the mesh of the whole run otherwise, which is another one.
void note_stop(const cancellation& stop, mesh_outcome& made) {
  if (!made.complete) return;
  const auto why = stop.told();
  if (!why) return;
  made.complete = false;
  made.ended.how = ending::stopped;
  made.ended.stopped_because = *why + ", while a mesh without faults was being improved";
}

}  // namespace

result<mesh_outcome> make_mesh(const domain& d, const metric_field& field,
                               const mesh_options& options, const progress_listener& progress) {
  mesh_options bounded = options;
  bounded.stop = with_run_work(options.stop);
  bounded.stop.expect(d.vertices.size());
  auto outcome = make_or_stop(d, field, bounded, progress);
  if (outcome) note_stop(options.stop, outcome.value());
  return outcome;
}

}  // namespace asterism
