// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/mesh_attempts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/pipeline/adaptation.hpp"
#include "asterism/mesh/pipeline/assign_regions.hpp"
#include "asterism/mesh/pipeline/given_order.hpp"
#include "asterism/mesh/pipeline/last_resort.hpp"
#include "asterism/mesh/pipeline/tolerated_metric.hpp"
#include "asterism/mesh/pipeline/unit_image.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism::internal {
namespace {

// Notes that the metric is another one altogether.
void note_excess(mesh_outcome& made, const mesh_options& options) {
  made.intolerable = excess_of(made, options);
  if (made.intolerable) made.complete = false;
}

// Returns the mesh delivered if it is what there is to show: near enough, or, where no tolerance is
// asked for, not complete but as near as was found.
std::optional<mesh_outcome> shown(std::optional<mesh_outcome>& delivered,
                                  const mesh_options& options) {
  if (!delivered) return std::nullopt;
  const auto excess = excess_of(*delivered, options);
  if (excess && excess->of == intolerable_distance::measure::greatest) return std::nullopt;
  note_excess(*delivered, options);
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
  if (wants_other_metric(made, options)) return true;
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

// Shares of the work of a run; what is left in the end is for one metric everywhere.
constexpr double for_delivery = 0.65, for_metric_wanted = 0.6;

// True if both ways may be gone to the end: a metric delivered, and, where none was within the
// tolerance, the one wanted.
bool may_go_both_ways(const mesh_options& options) {
  return may_adapt(options) && options.metric_tolerance.value_or(0) > 0;
}

// Returns the work for a run, as a multiple of what one way takes: for the second as much as it has
// with a tolerance of 0, so that no mesh made then is refused for a larger tolerance.
double work_for_ways(const mesh_options& options) {
  return may_go_both_ways(options) ? 1 + for_metric_wanted : 1;
}

// Makes a mesh in the metric wanted, in one delivered, or in one for all sites, whichever leads to
// one first.
class ways_to_mesh {
 public:
  // All must outlive it. Takes all work there is, of work_for_ways() ways.
  ways_to_mesh(const domain& d, const metric_field& field, const mesh_options& options,
               const progress_listener& progress, star_confirmation confirmed, bool may_deliver)
      : domain_(d),
        progress_(progress),
        options_(with_part_of_work(options, 1 / work_for_ways(options))),
        delivering_(with_part_of_work(options_, for_delivery)),
        going_on_(with_part_of_work(options, for_metric_wanted / work_for_ways(options))),
        field_(field),
        confirmed_(confirmed),
        delivery_(d, field, delivering_),
        image_(d, field, options_),
        is_first_(may_adapt(options) && delivery_.is_first_choice()),
        may_deliver_(may_deliver) {}

  result<mesh_outcome> run() {
    if (is_first_ && may_deliver_)
      if (auto made = deliver(0)) return *std::move(made);
    auto outcome = try_metric_wanted();
    if (!outcome) return outcome;
    if (may_adapt(options_) && !is_first_ && wants_delivery(outcome.value(), options_))
      if (auto made = deliver(few_sites(outcome.value()))) return *std::move(made);
    if (gave_up_early_ && may_go_both_ways(options_) && is_overworked(outcome)) {
      outcome = mesh_in_metric_wanted(going_on_, less);
      if (outcome) image_.outward(outcome.value());
    }
    if (outcome && wants_other_metric(outcome.value(), options_) && !options_.metric_tolerance)
      outcome = mesh_in_one_metric(std::move(outcome).value());
    if (!outcome) return outcome;
    if (delivered_ && !outcome.value().complete && !outcome.value().stopped)
      outcome = mesh_beyond_tolerance(std::move(outcome).value(), *std::move(delivered_), options_);
    outcome.value().counters = decided_;
    assign_regions(outcome.value().result, domain_);
    return outcome;
  }

 private:
  // Little is spent on finding out that a mesh is not likely, the metric varying too fast, and not
  // much where there are other ways.
  static constexpr double little = 0.1, less = 0.5;

  static bool is_overworked(const result<mesh_outcome>& made) {
    return made && made.value().ended.how == ending::overworked;
  }

  // Makes a mesh in a metric delivered; returns it if it is what there is to show.
  std::optional<mesh_outcome> deliver(std::size_t few) {
    delivering_.stop = options_.stop.part(for_delivery);
    delivered_ = delivery_.make(few);
    return shown(delivered_, options_);
  }

  // Returns how many sites a metric delivered has without a size.
  std::size_t few_sites(const mesh_outcome& made) const {
    constexpr std::size_t fewest = 400, most = 2000;
    return std::min(std::clamp(made.sites, fewest, most), options_.max_sites / 2);
  }

  // Makes a mesh in the metric wanted, with little work where another way is likelier to lead to
  // one; notes whether it was that little.
  result<mesh_outcome> try_metric_wanted() {
    const bool may_give_up = may_adapt(options_) && options_.metric_tolerance != 0.0 && !is_first_;
    const bool tries_little = may_give_up && delivery_.wants_few_sites();
    gave_up_early_ =
        tries_little || (may_give_up && (delivery_.jumps() || delivery_.varies_fast()));
    const double share = may_adapt(options_) ? less : 1;
    const mesh_options wanting = with_part_of_work(options_, for_metric_wanted);
    auto made = mesh_in_metric_wanted(wanting, gave_up_early_ ? little : share);
    if (tries_little && is_overworked(made) && !delivery_.varies_fast()) {
      gave_up_early_ = false;
      made = mesh_in_metric_wanted(wanting, less);
    }
    if (made) image_.outward(made.value());
    return made;
  }

  // Makes one with so much of the work that stars may take, in the frame.
  result<mesh_outcome> mesh_in_metric_wanted(const mesh_options& options, double share) {
    return mesh_domain(
        {stars_on_, image_.shape(), image_.field(), options, progress_, share, confirmed_});
  }

  // Leaves curves out: without demands, chords stay straight.
  result<mesh_outcome> mesh_in_one_metric(mesh_outcome as_wanted) {
    domain straight = domain_;
    straight.curves.clear();
    auto made = refine_in_one_metric({stars_on_, straight, field_, options_, progress_},
                                     std::move(as_wanted));
    if (made) note_excess(made.value(), options_);
    return made;
  }

  const domain& domain_;
  const progress_listener& progress_;
  const mesh_options options_;   // with the work of one way
  mesh_options delivering_;      // with a part of it
  const mesh_options going_on_;  // in the metric wanted, where another way was tried
  const metric_field& field_;
  const star_confirmation confirmed_;  // in the metric wanted
  metric_delivery delivery_;
  const unit_image image_;
  const bool is_first_;         // is a metric delivered what is tried first?
  const bool may_deliver_;      // or is it known that none leads to a mesh?
  bool gave_up_early_ = false;  // was little work to be done in the metric wanted?
  tier_counters decided_;
  const star_predicates_on<filtered_kernel> stars_on_{decided_};
  std::optional<mesh_outcome> delivered_;
};

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

result<mesh_outcome> make_by_attempts(const domain& d, const metric_field& field,
                                      const mesh_options& options,
                                      const progress_listener& progress,
                                      star_confirmation confirmed, bool may_deliver) {
  if (auto refused = check_options(d, options)) return *refused;
  mesh_options bounded = options;
  bounded.stop = with_run_work(options.stop, work_for_ways(options));
  bounded.stop.expect(d.vertices.size());
  // Confirms what an improvement starts from: it compares meshes, and keeps one.
  if (options.improve_passes > 0) confirmed = star_confirmation::by_mesher;
  const given_order order(d);
  auto outcome =
      ways_to_mesh(order.shape(), field, bounded, progress, confirmed, may_deliver).run();
  if (!outcome) return outcome;
  order.restore(outcome.value());
  note_stop(options.stop, outcome.value());
  return outcome;
}

}  // namespace asterism::internal
