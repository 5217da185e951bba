// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/refinement_loop.hpp"

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/refine/arc_insertion.hpp"
#include "asterism/mesh/refine/bad_triangle_queue.hpp"
#include "asterism/mesh/refine/delaunay_prerefinement.hpp"
#include "asterism/mesh/refine/insertion_tolerance.hpp"
#include "asterism/mesh/refine/poisson_darts.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/refine/stale_stars.hpp"
#include "asterism/mesh/refine/steepness.hpp"
#include "asterism/mesh/stars/equal_metric_stars.hpp"
#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal {
namespace {

// Return value of a phase that changed the mesh: the step begins again. Other values tell how
// refinement ended.
constexpr std::optional<ending> go_on;

// Returns the sharpest corner below the bound that has one of these sites beside it: at the corner,
// or on a segment of it.
std::optional<sharp_corner> sharpest_corner_beside(const refine_state& state,
                                                   const std::set<vertex_index>& beside,
                                                   double bound) {
  const domain_corner* sharpest = nullptr;
  const auto consider = [&](const domain_corner& c) {
    if (c.angle < bound && (sharpest == nullptr || c.angle < sharpest->angle)) sharpest = &c;
  };
  for (const vertex_index v : beside) {
    for (const domain_corner& c : state.segments().corners_at(v)) consider(c);
    for (const domain_wedge* w : state.segments().wedges().at_split(v)) consider(w->corner);
  }
  for (const domain_wedge& w : state.segments().wedges().all())
    if (beside.count(w.first_end) != 0 || beside.count(w.last_end) != 0) consider(w.corner);
  if (sharpest == nullptr) return std::nullopt;
  return sharp_corner{sharpest->vertex, state.sites()[sharpest->vertex].position, sharpest->angle};
}

std::set<vertex_index> sites_of(const std::set<bad_triangle>& bad) {
  std::set<vertex_index> all;
  for (const bad_triangle& b : bad) all.insert(b.where.begin(), b.where.end());
  return all;
}

class refinement_loop {
 public:
  // Leaves low angles beside the corners in `left_low` as they are.
  refinement_loop(refine_state state, const meshing_context& job,
                  const std::set<vertex_index>& left_low)
      : options_(job.options),
        left_low_(left_low),
        confirmed_(job.confirmed),
        progress_(job.progress),
        given_(static_cast<vertex_index>(job.shape.vertices.size())),
        state_(std::move(state)),
        angle_(options_.angle_bound),
        tolerance_(choose_tolerance(state_, given_, options_)),
        queue_(state_, angle_, options_.limit_size),
        steep_(state_, options_, tolerance_.finest),
        stars_(state_, steep_),
        arcs_(state_, queue_, steep_, angle_, tolerance_, options_.stop),
        darts_(options_.seed, options_.max_rejected, tolerance_.start, tolerance_.floor) {}
  refinement_loop(const refinement_loop&) = delete;
  refinement_loop& operator=(const refinement_loop&) = delete;

  result<mesh_outcome> run() {
    const bool cleared = prepare_segments();
    if (cleared)
      if (auto whole = triangulated_at_once()) return *std::move(whole);
    construct_stars();
    std::optional<ending> ended;
    while (!ended) ended = step();
    if (state_.field_failure()) return *state_.field_failure();
    const bool mended = *ended == ending::complete || *ended == ending::collateral;
    if (before_collateral_ && !mended) return without_collateral(*ended);
    // Frees the index to make room for the mesh, which is made from the stars alone.
    if (*ended == ending::complete) state_.forget_index();
    return outcome(*ended);
  }

  // Returns the corners beside which low angles could not be mended; the caller begins again
  // without demanding them.
  const std::set<vertex_index>& unmended() const { return unmended_; }

 private:
  // Splits subsegments that are too long or encroached, before there are stars: the number of stars
  // that a split changes grows with the length of the subsegment. Returns false when it ended
  // early.
  bool prepare_segments() {
    if (options_.limit_size) state_.shorten_subsegments(longest_subsegment);
    return state_.clear_encroachments(tolerance_.floor);
  }

  // Returns the mesh without making a star where it is one triangulation of sites that all have the
  // same metric, with no demand on angles or sizes: there would be nothing to mend. Returns none in
  // other cases, and where the run is stopped meanwhile.
  std::optional<mesh_outcome> triangulated_at_once() {
    if (angle_.degrees() > 0 || options_.limit_size) return std::nullopt;
    report_progress();
    auto triangles = triangles_of_equal_metrics(state_.oracle(), options_.stop, confirmed_);
    state_.is_overworked();  // charges the run's account
    if (!triangles || interruption()) return std::nullopt;
    consistency_report all_agree;
    all_agree.agreeing = *std::move(triangles);
    return outcome_with(ending::complete, std::move(all_agree));
  }

  // Makes all stars; where angles are demanded of many given sites, after prerefinement has mended
  // most low angles without stars.
  void construct_stars() {
    const neighbour_lists likely = is_refined_plainly(options_, given_)
                                       ? refine_plainly(state_, angle_, tolerance_, options_.stop)
                                       : neighbour_lists();
    if (likely.size() > 0)
      state_.construct_stars(likely, confirmed_ == star_confirmation::by_auditor
                                         ? star_confirmation::by_auditor_if_lengths_agree
                                         : confirmed_);
    else
      state_.construct_stars(confirmed_);
  }

  // Takes one step; returns how refinement ended, or go_on. The steps come to an end, because each
  // call inserts a site (bounded by max_sites), or settles a stale star or repairs one (there are
  // finitely many between insertions), or shrinks the tolerance towards its floor, or ends.
  std::optional<ending> step() {
    const bool cleared = state_.clear_encroachments(tolerance_.floor);
    queue_.update(state_);
    report_progress();
    if (const auto interrupted = interruption()) return interrupted;
    if (!cleared) return spent();
    if (stars_.rebuild_disagreeing(queue_)) return go_on;
    if (queue_.bad().empty()) return polish();
    if (state_.is_full()) return conclude(ending::site_limit);
    if (is_spent()) return give_up();
    if (insert()) return go_on;
    return exhaust();
  }

  void report_progress() {
    if (!progress_) return;
    progress_({mesh_phase::refining, state_.sites().size(), queue_.count(badness::disagreeing),
               queue_.count(badness::low_angle), queue_.count(badness::too_large)});
  }

  std::optional<ending> interruption() {
    if (state_.field_failure()) return ending::stuck;  // run() returns the failure
    const auto why = options_.stop.told();
    if (!why && !(options_.stop.units_left() > 0)) return ending::overworked;
    if (!why) return go_on;
    stopped_because_ = *why;
    return ending::stopped;
  }

  // Improves exempt corners, then settles and repairs stars, when nothing is bad; ends when there
  // is nothing to do.
  std::optional<ending> polish() {
    if (arcs_.insert_at_exempt_corners() || stars_.rebuild_all() || repair()) return go_on;
    // Ends as overworked if stars are missing: they have no triangles that could be bad.
    if (state_.stars().stars_missing() > 0) return ending::overworked;
    if (queue_.collateral() == 0) return ending::complete;
    if (before_collateral_) return ending::collateral;  // beside corners that keep low angles
    mend_collateral();
    return go_on;
  }

  // Tests every star against all sites, unless that is left to the auditor.
  bool repair() { return confirmed_ == star_confirmation::by_mesher && stars_.repair(); }

  // Demands the bound of collateral angles beside sharp corners, as the auditor does. That may need
  // ever smaller triangles, so the mesh made so far is kept, and few further sites are allowed: of
  // the wedges of 0.1 to 19 degrees that were tried, those that could be mended took up to 400
  // more.
  void mend_collateral() {
    constexpr std::size_t more = 500, more_for_each = 20;
    before_collateral_ = outcome(ending::collateral);
    state_.limit_sites(state_.sites().size() + more + more_for_each * queue_.collateral());
    queue_.demand_collateral(left_low_);
    arcs_.mend_collateral();
  }

  // Returns the mesh that was kept, as collateral angles could not be mended.
  mesh_outcome without_collateral(ending how) {
    unmended_ = queue_.corners_beside_low(state_);
    mesh_outcome o = std::move(*before_collateral_);
    o.stopped = how == ending::stopped;
    if (o.stopped) {
      o.ended.how = how;
      o.ended.stopped_because = stopped_because_;
    }
    o.candidates_rejected = arcs_.rejected() + darts_rejected_;
    return o;
  }

  // Returns `how` if no star is stale; otherwise makes stale stars anew and returns go_on.
  std::optional<ending> conclude(ending how) { return stars_.rebuild_all() ? go_on : how; }

  bool is_spent() const {
    return budget_exhausted_ || steep_.awaits_other_metric() || state_.is_overworked() ||
           steep_.has_waited_enough();
  }

  std::optional<ending> give_up() {
    const bool once_more = !steep_.awaits_other_metric() && !std::exchange(budget_exhausted_, true);
    if (once_more && stars_.rebuild_all()) return go_on;
    return spent();
  }

  ending spent() const { return state_.is_overworked() ? ending::overworked : ending::too_steep; }

  bool insert() {
    switch (options_.strategy) {
      case refinement_strategy::poisson_darts:
        return insert_by_darts();
      case refinement_strategy::fill:
        return (options_.limit_size && arcs_.insert_in_bulk()) || arcs_.insert();
      case refinement_strategy::voronoi_arcs:
        break;
    }
    return arcs_.insert();
  }

  bool insert_by_darts() {
    for (const bad_triangle& b : queue_.bad())
      if (shorten_tight_corner(state_, b.where, angle_, darts_.tolerance())) return true;
    const std::vector<bad_triangle> bad(queue_.bad().begin(), queue_.bad().end());
    return darts_.refine(state_, bad, darts_rejected_);
  }

  // Makes stale stars anew, or confirms stars again, when no site can be inserted; if neither
  // changes anything, refinement is stuck.
  std::optional<ending> exhaust() {
    if (stars_.rebuild_all() || stars_.confirm_again()) return go_on;
    return ending::stuck;
  }

  double tolerance_now() const {
    return options_.strategy == refinement_strategy::poisson_darts ? darts_.tolerance()
                                                                   : arcs_.tolerance();
  }

  refinement_ending explain(ending how) const {
    refinement_ending e;
    e.how = how;
    e.strategy = options_.strategy;
    e.max_sites = options_.max_sites;
    e.sites = state_.sites().size();
    e.bad_triangles = queue_.bad().size();
    e.stars_missing = state_.stars().stars_missing();
    e.tolerance = tolerance_now();
    e.stopped_because = stopped_because_;
    if (how == ending::too_steep) e.sites_since = steep_.sites_since();
    if (how == ending::collateral) {
      e.bad_triangles = queue_.collateral();
      e.sharpest = sharpest_corner_beside(state_, queue_.collateral_sites(), angle_.degrees());
    }
    if (how == ending::stuck || how == ending::too_steep || how == ending::overworked) {
      e.steep = steep_.first_place(queue_.bad());
      e.sharpest = sharpest_corner_beside(state_, sites_of(queue_.bad()), angle_.degrees());
    }
    return e;
  }

  mesh_outcome outcome(ending how) {
    if (how != ending::complete)
      return outcome_with(how, check_consistency(state_.oracle(), state_.stars()));
    // Skips the comparison of stars: the queue has made it, and the auditor makes it again.
    consistency_report all_agree;
    all_agree.agreeing = triangles_of_consistent(state_.stars());
    return outcome_with(how, std::move(all_agree));
  }

  mesh_outcome outcome_with(ending how, consistency_report now) {
    mesh_outcome o;
    o.complete = how == ending::complete;
    o.stopped = how == ending::stopped;
    o.ended = explain(how);
    o.jumps = steep_.jump_disagrees();
    o.result.sites = state_.sites();
    o.result.given = given_;
    o.result.triangles = std::move(now.agreeing);
    o.result.boundary = state_.edges().in_order();
    o.result.disagreeing = std::move(now.disagreeing);
    o.sites = o.result.sites.size();
    o.triangles = o.result.triangles.size();
    o.disagreeing = queue_.count(badness::disagreeing);
    o.low_angle = queue_.count(badness::low_angle);
    o.too_large = queue_.count(badness::too_large);
    o.splits = state_.segments().splits();
    o.inserted = o.sites - given_ - o.splits;
    o.candidates_rejected = arcs_.rejected() + darts_rejected_;
    o.exempt = queue_.exempt_corners();
    o.exempt_triangles = queue_.exempt();
    o.star_repairs = stars_.repairs();
    return o;
  }

  const mesh_options& options_;
  const std::set<vertex_index>& left_low_;
  star_confirmation confirmed_;
  std::set<vertex_index> unmended_;
  progress_listener progress_;
  vertex_index given_;
  refine_state state_;
  angle_requirement angle_;
  tolerance_range tolerance_;
  bad_triangle_queue queue_;
  steepness steep_;
  stale_stars stars_;
  arc_insertion arcs_;
  dart_thrower darts_;
  std::size_t darts_rejected_ = 0;
  bool budget_exhausted_ = false;
  std::optional<mesh_outcome> before_collateral_;
  std::string stopped_because_;
};

}  // namespace

// Mends low angles beside all sharp corners together or not at all: one corner whose refinement
// never ends takes all sites allowed. So refinement begins again without the corners at
// which mending failed; each round finds at least one more.
result<mesh_outcome> refine(const meshing_context& job, filled_domain proposed) {
  constexpr int rounds = 3;
  std::set<vertex_index> left_low;
  std::optional<mesh_outcome> best;
  for (int round = 0; round < rounds; ++round) {
    auto state = refine_state::start(job.shape, job.field, job.kernel, job.options.max_sites,
                                     proposed, job.options.stop, job.work_share);
    if (!state) return state.failure();
    proposed.stars = {};  // guesses, many for a large mesh: rounds that follow do without
    refinement_loop loop(std::move(state).value(), job, left_low);
    auto made = loop.run();
    if (!made) return made;
    const bool stopped = made.value().stopped;
    if (!best || made.value().complete ||
        (!stopped && made.value().ended.how == ending::collateral &&
         made.value().ended.bad_triangles < best->ended.bad_triangles))
      best = std::move(made).value();
    const std::size_t before = left_low.size();
    left_low.insert(loop.unmended().begin(), loop.unmended().end());
    if (stopped || left_low.size() == before) break;
  }
  return *std::move(best);
}

}  // namespace asterism::internal
