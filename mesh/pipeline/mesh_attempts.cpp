// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/mesh_attempts.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/delivery/constant_metric_fallback.hpp"
#include "asterism/mesh/delivery/metric_delivery.hpp"
#include "asterism/mesh/delivery/normalised_problem.hpp"
#include "asterism/mesh/delivery/tolerated_metric.hpp"
#include "asterism/mesh/pipeline/attempt_rules.hpp"
#include "asterism/mesh/pipeline/improved_mesh.hpp"
#include "asterism/mesh/pipeline/vertex_renumbering.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/stars/work_limit.hpp"

namespace asterism::internal {
namespace {

// Marks the outcome as not complete where its metric is too far from the one wanted.
void note_excess(mesh_outcome& made, const mesh_options& options) {
  made.intolerable = excess_of(made, options);
  if (made.intolerable) made.complete = false;
}

// Returns the delivered mesh if it is to be shown: within the tolerance, or, without a tolerance,
// not complete but the nearest found.
std::optional<mesh_outcome> shown(std::optional<mesh_outcome>& delivered,
                                  const mesh_options& options) {
  if (!delivered) return std::nullopt;
  const auto excess = excess_of(*delivered, options);
  if (excess && excess->of == intolerable_distance::measure::greatest) return std::nullopt;
  note_excess(*delivered, options);
  return std::move(delivered);
}

bool has_one_metric(const mesh& m) {
  return std::all_of(m.sites.begin(), m.sites.end(),
                     [&m](const site& s) { return identical(s.metric, m.sites.front().metric); });
}

// True if stars disagree or angles are low, which another metric may mend. False where the limit on
// sites made edges longer, or angles are low in one metric for all or beside sharp corners alone:
// then the domain or its size is the cause.
bool wants_delivery(const mesh_outcome& made, const mesh_options& options) {
  if (wants_other_metric(made, options)) return true;
  return !made.complete && !made.stopped && made.ended.how != ending::complete &&
         made.ended.how != ending::site_limit && made.ended.how != ending::collateral &&
         !has_one_metric(made.result);
}

// Returns the options with a stop that limits the work to this share of what is left.
mesh_options with_part_of_work(const mesh_options& options, double share) {
  mesh_options limited = options;
  limited.stop = options.stop.part(share);
  return limited;
}

// Shares of the work for two kinds of attempts; the work left after them is for one metric for all
// sites.
constexpr double for_delivery = attempt_rules[0].share_of_work,
                 for_metric_wanted = attempt_rules[2].share_of_work;

// True if two full attempts may be needed: a metric delivered, and the metric wanted where no
// delivered one was within the tolerance.
bool may_go_both_ways(const mesh_options& options) {
  return may_adapt(options) && options.metric_tolerance.value_or(0) > 0;
}

// Returns the work limit of all attempts together, as a multiple of the limit of one attempt. The
// second attempt has the work that it has with a tolerance of 0, so raising the tolerance never
// loses a mesh.
double work_for_ways(const mesh_options& options) {
  return may_go_both_ways(options) ? 1 + for_metric_wanted : 1;
}

// Goes through the list of attempts, and chooses the mesh that is shown.
class attempts_at_mesh {
 public:
  // Takes the budget of work_for_ways() attempts. References must outlive the object.
  attempts_at_mesh(const domain& d, const metric_field& field, const mesh_options& options,
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
    for (const step& next : steps) {
      if (!(this->*next.is_due)()) continue;
      if (auto failed = (this->*next.make)(*next.what)) return *failed;
      if (shown_) return with_report(*std::move(shown_));
    }
    choose();
    as_wanted_->counters = decided_;
    assign_regions(as_wanted_->result, domain_);
    return with_report(*std::move(as_wanted_));
  }

 private:
  using failure = std::optional<error>;
  struct step {
    const attempt_rule* what;
    bool (attempts_at_mesh::*is_due)();
    failure (attempts_at_mesh::*make)(const attempt_rule&);
  };
  static const std::array<step, attempt_count> steps;

  bool is_overworked() const { return as_wanted_ && as_wanted_->ended.how == ending::overworked; }

  // True if the attempts begin with a delivered metric. The preconditions follow in the order of
  // the list; each is evaluated once.
  bool begins_with_delivery() { return is_first_ && may_deliver_; }

  // True if the attempt in the wanted metric is unlikely to lead to a mesh, or that metric wants
  // few sites. Remembers both answers, since the attempt then gets a small share of the work.
  bool is_mesh_unlikely() {
    const bool may_give_up = may_adapt(options_) && options_.metric_tolerance != 0.0 && !is_first_;
    wants_few_ = may_give_up && delivery_.wants_few_sites();
    gave_up_early_ = wants_few_ || (may_give_up && (delivery_.jumps() || delivery_.varies_fast()));
    return gave_up_early_;
  }

  bool is_metric_wanted_due() {
    if (as_wanted_ && !(wants_few_ && is_overworked() && !delivery_.varies_fast())) return false;
    gave_up_early_ = false;
    return true;
  }

  bool wants_other() {
    return may_adapt(options_) && !is_first_ && wants_delivery(*as_wanted_, options_);
  }

  bool may_go_on() { return gave_up_early_ && may_go_both_ways(options_) && is_overworked(); }

  bool wants_one_metric() {
    return wants_other_metric(*as_wanted_, options_) && !options_.metric_tolerance;
  }

  // Makes a mesh in a delivered metric, and chooses it if it is within the tolerance. Without a
  // size it aims at about the number of sites of the mesh in the wanted metric.
  failure deliver(const attempt_rule& by) {
    constexpr std::size_t fewest = 400, most = 2000;
    const std::size_t few =
        as_wanted_ ? std::min(std::clamp(as_wanted_->sites, fewest, most), options_.max_sites / 2)
                   : 0;
    delivering_.stop = options_.stop.part(by.share_of_work);
    delivered_ = delivery_.make(few);
    note(by, delivered_ ? &*delivered_ : nullptr);
    delivered_by_ = by.what;
    shown_ = shown(delivered_, options_);
    if (shown_) chosen_ = by.what;
    return std::nullopt;
  }

  // Makes a mesh in the wanted metric, in the unit frame, and scales it back.
  failure keep_to_metric(const attempt_rule& by, const mesh_options& options, double share) {
    const meshing_context job{stars_on_, image_.shape(), image_.field(), options,
                              progress_, share,          confirmed_};
    auto made = mesh_domain(job);
    if (!made) return made.failure();
    as_wanted_ = std::move(made).value();
    improve(job, *as_wanted_);
    image_.outward(*as_wanted_);
    note(by, &*as_wanted_);
    chosen_ = by.what;
    return std::nullopt;
  }

  failure keep_briefly(const attempt_rule& by) {
    wanting_ = with_part_of_work(options_, by.share_of_work);
    return keep_to_metric(by, *wanting_, by.share_of_stars);
  }

  failure keep(const attempt_rule& by) {
    if (!wanting_) wanting_ = with_part_of_work(options_, by.share_of_work);
    return keep_to_metric(by, *wanting_, may_adapt(options_) ? by.share_of_stars : 1);
  }

  failure go_on(const attempt_rule& by) { return keep_to_metric(by, going_on_, by.share_of_stars); }

  // Makes a mesh in one metric. Leaves curves out: without demands, chords stay straight.
  failure take_one_metric(const attempt_rule& by) {
    domain straight = domain_;
    straight.curves.clear();
    auto made = refine_in_one_metric({stars_on_, straight, field_, options_, progress_},
                                     *std::move(as_wanted_));
    if (!made) return made.failure();
    as_wanted_ = std::move(made).value();
    note_excess(*as_wanted_, options_);
    note(by, as_wanted_->one_metric ? &*as_wanted_ : nullptr);
    if (as_wanted_->one_metric) chosen_ = by.what;
    return std::nullopt;
  }

  // Chooses the mesh to show where no metric within the tolerance led to one. With a tolerance of 0
  // that is the mesh of the metric wanted, whose stars do not all agree; else the mesh of a metric
  // that is too far away, whose stars do.
  void choose() {
    if (!delivered_ || as_wanted_->complete || as_wanted_->stopped) return;
    const auto found = excess_of(*delivered_, options_);
    if (!found) return;
    if (found->allowed > 0) {
      as_wanted_ = std::move(delivered_);
      chosen_ = delivered_by_;
    }
    as_wanted_->intolerable = found;
    as_wanted_->complete = false;
  }

  void note(const attempt_rule& by, const mesh_outcome* made) {
    tried_.push_back({by.what, made != nullptr ? std::optional(made->how()) : std::nullopt});
  }

  mesh_outcome with_report(mesh_outcome made) {
    made.tried = std::move(tried_);
    made.chosen = chosen_;
    return made;
  }

  const domain& domain_;
  const progress_listener& progress_;
  const mesh_options options_;   // with the work of one way
  mesh_options delivering_;      // with a part of it
  const mesh_options going_on_;  // in the metric wanted, where another way was tried
  std::optional<mesh_options> wanting_;
  const metric_field& field_;
  const star_confirmation confirmed_;  // in the metric wanted
  metric_delivery delivery_;
  const normalised_problem image_;
  const bool is_first_;         // is a metric delivered what is tried first?
  const bool may_deliver_;      // or is it known that none leads to a mesh?
  bool wants_few_ = false;      // are few sites wanted, so that it costs little to try?
  bool gave_up_early_ = false;  // was little work to be done in the metric wanted?
  tier_counters decided_;
  const star_predicates_on<filtered_kernel> stars_on_{decided_};
  std::optional<mesh_outcome> as_wanted_, delivered_, shown_;
  std::vector<attempt_report> tried_;
  std::optional<mesh_attempt> chosen_, delivered_by_;
};

const std::array<attempts_at_mesh::step, attempt_count> attempts_at_mesh::steps = {{
    {&attempt_rules[0], &attempts_at_mesh::begins_with_delivery, &attempts_at_mesh::deliver},
    {&attempt_rules[1], &attempts_at_mesh::is_mesh_unlikely, &attempts_at_mesh::keep_briefly},
    {&attempt_rules[2], &attempts_at_mesh::is_metric_wanted_due, &attempts_at_mesh::keep},
    {&attempt_rules[3], &attempts_at_mesh::wants_other, &attempts_at_mesh::deliver},
    {&attempt_rules[4], &attempts_at_mesh::may_go_on, &attempts_at_mesh::go_on},
    {&attempt_rules[5], &attempts_at_mesh::wants_one_metric, &attempts_at_mesh::take_one_metric},
}};

// Marks a mesh whose improvement was cut short by a limit or an interrupt: without the mark it
// could be mistaken for the mesh of the uninterrupted run, which differs.
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
  // Makes the mesher confirm all stars of the mesh that an improvement starts from: passes are
  // compared with it.
  if (options.improve_passes > 0) confirmed = star_confirmation::by_mesher;
  const vertex_renumbering order(d);
  auto outcome =
      attempts_at_mesh(order.shape(), field, bounded, progress, confirmed, may_deliver).run();
  if (!outcome) return outcome;
  order.restore(outcome.value());
  note_stop(options.stop, outcome.value());
  return outcome;
}

}  // namespace asterism::internal
