// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/refinement_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "asterism/mesh/metric/unit_frame.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/refine/bad_triangle_queue.hpp"
#include "asterism/mesh/refine/coarsening_pass.hpp"
#include "asterism/mesh/refine/insertion_tolerance.hpp"
#include "asterism/mesh/refine/poisson_darts.hpp"
#include "asterism/mesh/refine/site_budget.hpp"
#include "asterism/mesh/refine/voronoi_arc_candidates.hpp"

namespace asterism::internal {
namespace {

// Up to this sigma * distance refinement has been seen to reach 20 degrees; the proof wants 0.052
// (docs/math/refinement.md). Beyond it a triangle is given up, so the greater of the two.
constexpr double resolved_variation = 0.3;
// Sites whose metrics differ less than this, the root of the golden ratio, have wedged arcs at any
// distance that a net has (the same page, point 4).
constexpr double resolved_distortion = 1.272;

class refinement {
 public:
  // `frame` is the one the state is in.
  refinement(refine_state state, const unit_frame& frame, const mesh_options& options,
             vertex_index given, const std::function<void(const mesh_progress&)>& progress)
      : state_(std::move(state)),
        frame_(frame),
        options_(options),
        progress_(progress),
        angle_(options.angle_bound),
        tolerance_(choose_tolerance(state_, given, options)),
        darts_(options.seed, options.max_rejected, tolerance_.start, tolerance_.floor),
        tolerance_now_(tolerance_.start),
        survey_(state_, angle_, options.limit_size),
        given_(given) {}

  result<mesh_outcome> run() {
    if (options_.limit_size) state_.shorten_subsegments(longest_subsegment);
    while (!ended_) step();
    if (state_.field_failure()) return *state_.field_failure();
    return outcome();
  }

 private:
  // Ends because each call inserts a site (bounded by max_sites), or settles a stale star or
  // repairs one (there are finitely many between insertions), or shrinks the tolerance towards its
  // floor, or ends.
  void step() {
    const bool cleared = state_.clear_encroachments(tolerance_.floor);
    survey_.update(state_);
    report_progress();
    if (state_.field_failure()) return end("the metric field failed");
    if (options_.stop)
      if (const auto why = options_.stop()) {
        stopped_ = true;
        return end("stopped: " + *why);
      }
    if (!cleared) return end(spent_message());
    if (rebuild_disagreeing()) return;
    if (survey_.bad().empty()) {
      if (improve_at_exempt_corners()) return;
      if (rebuild_all_stale() || repair()) return;
      complete_ = true;
      return end("all stars agree and every triangle meets the bound");
    }
    if (state_.is_full()) {
      if (rebuild_all_stale()) return;
      return end("the limit of " + std::to_string(options_.max_sites) + " sites was reached");
    }
    if (is_spent()) {
      const bool again = !is_for_relaxation() && !std::exchange(budget_exhausted_, true);
      if (again && rebuild_all_stale()) return;
      return end(spent_message());
    }
    if (improve()) return;
    if (rebuild_all_stale()) return;
    if (confirmed_at_ != state_.sites().size()) {
      confirmed_at_ = 0;  // once more before giving up
      return;
    }
    end(stuck_message());
  }

  void end(std::string reason) {
    reason_ = std::move(reason);
    ended_ = true;
  }

  // Coarse stars keep neighbours they should not, and near searches miss some: before a site is
  // inserted for a disagreement, the stars in it are made anew, and held against all sites.
  bool rebuild_disagreeing() {
    const star_set& stars = state_.stars();
    std::vector<vertex_index> stale, unconfirmed;
    for (const bad_triangle& b : survey_.bad()) {
      if (b.why != badness::disagreeing) break;
      // At a jump of the metric most sites are in reach of most others.
      const bool given_up = unresolvable_.count(b.where) != 0 || is_at_jump(b);
      if (given_up) continue;
      for (const vertex_index v : b.where) {
        if (stars.is_stale(v)) stale.push_back(v);
        if (!stars.is_confirmed(v) && !stars.is_unsettled(v)) unconfirmed.push_back(v);
      }
    }
    if (is_for_relaxation()) return false;
    if (rebuild(std::move(stale), star_search::near)) return true;
    // Where metrics vary much all sites are in reach, so this waits until there are a tenth more.
    if (10 * state_.sites().size() < 11 * confirmed_at_) return false;
    confirmed_at_ = state_.sites().size();
    return rebuild(std::move(unconfirmed), star_search::thorough);
  }

  // Whether there have been enough more sites since the first triangle was given up. The mesh
  // cannot become complete any more, and beside a jump of the metric stars with thousands of
  // neighbours keep the others from agreeing; to go on to the floor would take days.
  bool is_spent() const {
    constexpr std::size_t at_least = 1000;
    return budget_exhausted_ || is_for_relaxation() || state_.is_overworked() ||
           (!unresolvable_.empty() &&
            state_.sites().size() > given_up_at_ + std::max(at_least, given_up_at_ / 16));
  }

  // What disagrees across a jump goes on to, whatever is mended elsewhere: the metric will be
  // relaxed for it, and all be meshed anew (pipeline/metric_relaxation.hpp).
  bool is_for_relaxation() const { return options_.relax && jump_disagrees_; }

  bool rebuild_all_stale() {
    std::vector<vertex_index> stale;
    for (vertex_index v = 0; v < state_.stars().size(); ++v)
      if (state_.stars().is_stale(v)) stale.push_back(v);
    return rebuild(std::move(stale), star_search::near);
  }

  bool rebuild(std::vector<vertex_index> stale, star_search search) {
    std::sort(stale.begin(), stale.end());
    stale.erase(std::unique(stale.begin(), stale.end()), stale.end());
    return !state_.stars().construct(state_.oracle(), stale, search).empty();
  }

  // What a local search can have missed: every star is held against all sites that are not
  // certainly out of its reach. Sites that were there the last time need not be looked at again
  // only because others came, so this is done once for each state of the mesh.
  bool repair() {
    if (thorough_at_ == state_.sites().size()) return false;
    thorough_at_ = state_.sites().size();
    std::vector<vertex_index> all(state_.sites().size());
    std::iota(all.begin(), all.end(), vertex_index{0});
    const std::size_t repaired =
        state_.stars().construct(state_.oracle(), all, star_search::thorough).size();
    repairs_ += repaired;
    return repaired > 0;
  }

  bool improve() {
    if (options_.strategy == refinement_strategy::poisson_darts) return improve_by_darts();
    if (options_.strategy == refinement_strategy::fill && options_.limit_size && improve_in_bulk())
      return true;
    while (true) {
      for (const bad_triangle& b : survey_.bad()) {
        if (state_.is_overworked()) return true;  // is_spent() ends it
        if (failed_at_tolerance_.count(b) != 0 || unresolvable_.count(b.where) != 0) continue;
        if (is_at_jump(b)) continue;
        const bool inserted = shorten_tight_corner(state_, b.where, angle_, tolerance_now_) ||
                              refine_by_arcs(state_, b.where, tolerance_now_, rejected_);
        if (state_.field_failure()) return false;
        if (!inserted) {
          failed_at_tolerance_.insert(b);
          continue;
        }
        retry_ = true;
        if (b.why == badness::too_large) insert_for_large();
        return true;
      }
      // Those that failed may succeed where something has changed since.
      failed_at_tolerance_.clear();
      if (std::exchange(retry_, false)) continue;
      if (tolerance_now_ <= tolerance_.floor) return false;
      if (options_.stop && options_.stop()) return true;  // step() ends it
      tolerance_now_ = std::max(tolerance_.floor, tolerance_.shrink * tolerance_now_);
    }
  }

  // Many bad triangles at once: each is given a site unless one of its sites, or a neighbour of
  // one, already was in a triangle that got one; what comes of it is then looked at anew.
  // Subsegments are split one by one, in improve().
  bool improve_in_bulk() {
    constexpr std::size_t fewest = 32;
    if (survey_.bad().size() < fewest) return false;
    std::vector<char> busy(state_.sites().size(), 0);
    bool any = false;
    for (const bad_triangle& b : survey_.bad()) {
      if (state_.is_full() || state_.is_overworked()) break;
      if (failed_at_tolerance_.count(b) != 0 || unresolvable_.count(b.where) != 0) continue;
      if (std::any_of(b.where.begin(), b.where.end(), [&](vertex_index v) { return busy[v] != 0; }))
        continue;
      if (is_at_jump(b)) continue;
      const auto s = find_place(state_, b.where, tolerance_now_, rejected_);
      if (state_.field_failure()) break;
      if (!s) continue;
      state_.add_interior_later(*s);
      any = true;
      for (const vertex_index v : b.where) {
        busy[v] = 1;
        for (const sector& part : state_.stars()[v].sectors)
          for (const vertex_index u : part.neighbours) busy[u] = 1;
      }
    }
    if (any) state_.add_stars();
    retry_ = retry_ || any;
    return any && !state_.field_failure();
  }

  // Whether the triangle, or one that shares a site with it, lies across a place where the metric
  // is too steep; then it is put aside for good.
  bool is_at_jump(const bad_triangle& b) {
    if (options_.strategy != refinement_strategy::fill) return false;
    // Without a size triangles may be so large that the metric is another at every corner.
    if (!options_.limit_size && b.why != badness::disagreeing) return false;
    const bool beside = b.why != badness::too_large &&
                        std::any_of(b.where.begin(), b.where.end(),
                                    [this](vertex_index v) { return at_jump_.count(v) != 0; });
    if (!beside && !is_too_steep(b.where)) return false;
    if (unresolvable_.empty()) given_up_at_ = state_.sites().size();
    if (!beside) at_jump_.insert(b.where.begin(), b.where.end());
    if (b.why == badness::disagreeing) jump_disagrees_ = true;
    unresolvable_.insert(b.where);
    return true;
  }

  // Where the metric varies faster than sites at the floor could resolve (docs/math/refinement.md:
  // there are no defects where sigma times the distance of sites is small), more sites are of no
  // use; at a jump of the metric they would pile up for ever.
  bool is_too_steep(const triangle& t) {
    const double most = resolved_variation / tolerance_.finest;
    const triangle_sites sites = sites_of(state_, t);
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] != t[(i + 1) % 3] && steepest_between(sites[i], sites[(i + 1) % 3], most) > most)
        return true;
    return false;
  }

  // The variation of the metric where it is greatest on the way from p to q, found by following the
  // half over which it changes more; down to where sites could be no nearer.
  double steepest_between(site p, site q, double enough) {
    double steepest = variation(p, q);
    while (steepest <= enough && distortion(p.metric, q.metric) > resolved_distortion) {
      const auto middle = state_.site_at({p.position.x + (q.position.x - p.position.x) / 2,
                                          p.position.y + (q.position.y - p.position.y) / 2});
      if (!middle || middle->position == p.position || middle->position == q.position) break;
      const bool first =
          distortion(p.metric, middle->metric) >= distortion(middle->metric, q.metric);
      (first ? q : p) = *middle;
      steepest = std::max(steepest, variation(p, q));
    }
    return steepest;
  }

  // A sharp corner excuses its own angle; the others of its triangles are mended where the arcs
  // offer something not far below the tolerance of the beginning, so that this cannot run away.
  bool improve_at_exempt_corners() {
    if (state_.is_full()) return false;
    constexpr double modest = 0x1p-4;
    const double tolerance = std::max(tolerance_.floor, modest * tolerance_.start);
    for (const bad_triangle& b : survey_.improvable())
      if (shorten_tight_corner(state_, b.where, angle_, tolerance) ||
          refine_by_arcs(state_, b.where, tolerance, rejected_))
        return true;
    return false;
  }

  // Where nothing but size is left to mend, the order matters little: one survey serves many
  // insertions. Triangles that have gone meanwhile are passed over.
  void insert_for_large() {
    for (const bad_triangle& b : survey_.bad()) {
      if (state_.is_full() || state_.is_overworked() || state_.field_failure()) return;
      const auto [v, y, x] = b.where;
      if (failed_at_tolerance_.count(b) == 0 && unresolvable_.count(b.where) == 0 &&
          has_triangle(state_.oracle(), v, state_.stars()[v], y, x))
        refine_by_arcs(state_, b.where, tolerance_now_, rejected_);
    }
  }

  bool improve_by_darts() {
    for (const bad_triangle& b : survey_.bad())
      if (shorten_tight_corner(state_, b.where, angle_, tolerance_now_)) return true;
    const std::vector<bad_triangle> bad(survey_.bad().begin(), survey_.bad().end());
    const bool inserted = darts_.refine(state_, bad, rejected_);
    tolerance_now_ = darts_.tolerance();
    return inserted;
  }

  // Names a place, if the metric is too steep at any triangle that is still bad.
  std::string steep_message() const {
    std::size_t count = 0;
    std::optional<triangle> first;
    for (const bad_triangle& b : survey_.bad()) {
      if (unresolvable_.count(b.where) == 0) continue;
      ++count;
      if (!first) first = b.where;
    }
    if (!first) return "";
    const point at = frame_.outward(state_.sites()[(*first)[0]].position);
    return "; at " + std::to_string(count) + " of them, one at (" + format_number(at.x) + ", " +
           format_number(at.y) + "), the metric varies faster than sites " +
           format_number(frame_.length_outward(tolerance_.finest)) +
           " apart can resolve (a gradation of it might do)";
  }

  // Names the sharpest of the corners that bad triangles are beside: with a site at one, or on a
  // segment of one.
  std::string corner_message() const {
    const domain_corner* sharpest = nullptr;
    const auto consider = [&](const domain_corner& c) {
      if (c.angle < angle_.degrees() && (sharpest == nullptr || c.angle < sharpest->angle))
        sharpest = &c;
    };
    std::set<vertex_index> bad;
    for (const bad_triangle& b : survey_.bad()) bad.insert(b.where.begin(), b.where.end());
    for (const vertex_index v : bad) {
      for (const domain_corner& c : state_.corners_at(v)) consider(c);
      for (const domain_wedge* w : state_.wedges_at_split(v)) consider(w->corner);
    }
    for (const domain_wedge& w : state_.wedges())
      if (bad.count(w.first_end) != 0 || bad.count(w.last_end) != 0) consider(w.corner);
    if (sharpest == nullptr) return "";
    const point at = frame_.outward(state_.sites()[sharpest->vertex].position);
    return "; the sharpest corner beside them is vertex " + std::to_string(sharpest->vertex + 1) +
           " at (" + format_number(at.x) + ", " + format_number(at.y) + "), " +
           format_number(sharpest->angle) + " degrees";
  }

  std::string stuck_message() const {
    const char* tried = options_.strategy == refinement_strategy::poisson_darts
                            ? "darts"
                            : "candidates on Voronoi arcs";
    return "stuck: " + std::to_string(survey_.bad().size()) + " bad triangles are left, and no " +
           tried + " farther than the tolerance " +
           format_number(frame_.length_outward(tolerance_now_)) +
           " from every site can be inserted" + steep_message() + corner_message();
  }

  std::string spent_message() const {
    const std::string left =
        "given up: " + std::to_string(survey_.bad().size()) + " bad triangles are left after ";
    if (state_.is_overworked())
      return left + "the most work that is done for so many sites" + steep_message() +
             corner_message();
    return left + std::to_string(state_.sites().size() - given_up_at_) +
           " sites more than there were when the first could not be mended" + steep_message() +
           corner_message();
  }

  void report_progress() {
    if (!progress_) return;
    progress_({mesh_phase::refining, state_.sites().size(), survey_.count(badness::disagreeing),
               survey_.count(badness::low_angle), survey_.count(badness::too_large)});
  }

  mesh_outcome outcome() {
    mesh_outcome o;
    consistency_report now = check_consistency(state_.oracle(), state_.stars());
    o.complete = complete_;
    o.stopped = stopped_;
    o.jumps = jump_disagrees_;
    o.reason = reason_;
    o.stars_missing = state_.stars().stars_missing();
    if (o.stars_missing > 0)
      o.reason += "; the stars of " + std::to_string(o.stars_missing) + " of " +
                  std::to_string(state_.sites().size()) + " sites were never made";
    o.result.sites = state_.sites();
    o.result.given = given_;
    o.result.triangles = std::move(now.agreeing);
    o.result.boundary = state_.edges().in_order();
    o.result.disagreeing = std::move(now.disagreeing);
    frame_.outward(o.result);
    o.tolerance = frame_.length_outward(tolerance_now_);
    o.sites = o.result.sites.size();
    o.triangles = o.result.triangles.size();
    o.disagreeing = survey_.count(badness::disagreeing);
    o.low_angle = survey_.count(badness::low_angle);
    o.too_large = survey_.count(badness::too_large);
    o.splits = state_.splits();
    o.inserted = o.sites - given_ - o.splits;
    o.candidates_rejected = rejected_;
    o.exempt = survey_.exempt_corners();
    o.exempt_triangles = survey_.exempt();
    o.star_repairs = repairs_;
    return o;
  }

  refine_state state_;
  unit_frame frame_;
  const mesh_options& options_;
  const std::function<void(const mesh_progress&)>& progress_;
  angle_requirement angle_;
  tolerance_range tolerance_;
  dart_thrower darts_;
  double tolerance_now_;
  survey survey_;
  std::set<bad_triangle> failed_at_tolerance_;  // tried in vain with the tolerance in force
  bool retry_ = false;                          // something was inserted since some were parked
  vertex_index given_;
  std::set<triangle> unresolvable_;  // where the metric varies too fast
  std::set<vertex_index> at_jump_;   // the sites of the triangles across such places
  std::size_t repairs_ = 0, thorough_at_ = 0, confirmed_at_ = 0;  // the last two: numbers of sites
  std::size_t given_up_at_ = 0;  // the number of sites when the first triangle became steep
  bool budget_exhausted_ = false, jump_disagrees_ = false;
  std::size_t rejected_ = 0;
  bool complete_ = false, ended_ = false, stopped_ = false;
  std::string reason_;
};

std::optional<error> check_options(const domain& d, const mesh_options& o) {
  const auto refuse = [](const std::string& what, const std::string& got) {
    return error{what + ", not " + got};
  };
  if (!(o.angle_bound >= 0 && o.angle_bound < 60))
    return refuse("the angle bound must be at least 0 and less than 60 degrees",
                  format_number(o.angle_bound));
  if (o.tolerance && !(*o.tolerance > 0 && std::isfinite(*o.tolerance)))
    return refuse("the tolerance must be positive and finite", format_number(*o.tolerance));
  if (o.max_rejected < 1)
    return refuse("the number of rejected darts must be at least 1",
                  std::to_string(o.max_rejected));
  if (o.max_sites < d.vertices.size())
    return refuse("the limit on sites must be at least " + std::to_string(d.vertices.size()) +
                      ", the number of the domain's vertices",
                  std::to_string(o.max_sites));
  return std::nullopt;
}

result<mesh_outcome> refine_image(const filled_domain& proposed, const unit_frame& frame,
                                  const star_predicates& kernel, const domain& image,
                                  const metric_field& field, const mesh_options& options,
                                  const std::function<void(const mesh_progress&)>& progress) {
  std::function<bool()> enough;
  if (options.stop) enough = [&options] { return options.stop().has_value(); };
  auto state = refine_state::start_filled(image, field, kernel, options.max_sites, proposed,
                                          std::move(enough));
  if (!state) return state.failure();
  return refinement(std::move(state).value(), frame, options,
                    static_cast<vertex_index>(image.vertices.size()), progress)
      .run();
}

// And improved, if that is asked for.
result<mesh_outcome> refine_and_improve(const budgeted_filling& filled,
                                        const star_predicates& kernel, const domain& image,
                                        const metric_field& field, const mesh_options& options,
                                        const std::function<void(const mesh_progress&)>& progress) {
  const unit_frame& frame = filled.frame;
  auto made = refine_image(filled.proposed, frame, kernel, image, field, options, progress);
  // One that was filled coarser than asked for is not complete, whatever it says of itself.
  if (!made || filled.halvings > 0) return made;
  const auto again = [&](const filled_domain& proposed, std::size_t most_sites) {
    const auto own_kernel = kernel.fork();  // the work done for one mesh is counted from zero
    mesh_options limited = options;
    limited.max_sites = most_sites;
    auto tried = refine_image(proposed, frame, *own_kernel, image, field, limited, progress);
    kernel.count(own_kernel->counters());
    return tried;
  };
  improve(image, field, frame, options, again, made.value());
  return made;
}

// The proposed sites refined in their frame; what came of it is in the domain's own units.
result<mesh_outcome> refine_filled(const budgeted_filling& filled, const star_predicates& kernel,
                                   const domain& d, const metric_field& field,
                                   const mesh_options& options,
                                   const std::function<void(const mesh_progress&)>& progress) {
  const unit_frame& frame = filled.frame;
  if (frame.is_identity()) return refine_and_improve(filled, kernel, d, field, options, progress);
  return refine_and_improve(filled, kernel, frame.inward(d), framed_field(field, frame), options,
                            progress);
}

// Without room for another site: complete if there is nothing to mend.
result<mesh_outcome> refine_as_given(const unit_frame& frame, const star_predicates& kernel,
                                     const domain& d, const metric_field& field,
                                     mesh_options options,
                                     const std::function<void(const mesh_progress&)>& progress) {
  options.max_sites = d.vertices.size();
  options.improve_passes = 0;  // what is given stays
  budgeted_filling nothing{{}, frame, 0};
  nothing.proposed.divisions.resize(d.segments.size());
  auto made = refine_filled(nothing, kernel, d, field, options, progress);
  if (made && made.value().complete) made.value().reason = "nothing to add: " + made.value().reason;
  return made;
}

bool is_final(const result<mesh_outcome>& kept) {
  return !kept || kept.value().sites_wanted > 0 || kept.value().complete || kept.value().stopped;
}

}  // namespace

result<mesh_outcome> mesh_domain(const star_predicates& kernel, const domain& d,
                                 const metric_field& field, const mesh_options& options,
                                 const std::function<void(const mesh_progress&)>& progress) {
  if (const auto refused = check_options(d, options)) return *refused;
  const bool lengths_are_free = !options.limit_size && !options.tolerance;
  const unit_frame frame = unit_frame::choose(d, field, lengths_are_free);
  const auto as_given = [&](int halvings) {
    auto kept = refine_as_given(frame.length_factor(halvings), kernel, d, field, options, progress);
    if (kept && kept.value().complete) report_coarser(halvings, false, options, kept.value());
    return kept;
  };
  if (options.keep_if_complete)
    if (auto kept = as_given(0); is_final(kept)) return kept;
  const auto filled = fill_within_budget(frame, d, field, options, progress);
  if (!filled) return filled.failure();
  if (filled.value().proposed.crowded) {
    // Its sites are each in reach of most others: exact stars of them would take hours.
    auto kept = refine_as_given(frame, kernel, d, field, options, progress);
    if (kept) report_crowded(filled.value(), kept.value());
    return kept;
  }
  const int halvings = filled.value().halvings;
  // What the limit allows may be there already. A mesh made under the same limit is filled anew
  // with all its vertices given, which may come out finer: by less than edges half as long.
  const int coarsest = halvings > 0 && options.keep_if_complete ? halvings + 2 : 0;
  for (int fewer = 1; fewer <= coarsest; ++fewer)
    if (auto kept = as_given(fewer); is_final(kept)) return kept;
  return mesh_from_sites(filled.value(), kernel, d, field, options, progress);
}

result<mesh_outcome> mesh_from_sites(const budgeted_filling& filled, const star_predicates& kernel,
                                     const domain& d, const metric_field& field,
                                     const mesh_options& options,
                                     const std::function<void(const mesh_progress&)>& progress) {
  auto made = refine_filled(filled, kernel, d, field, options, progress);
  if (made) report_coarser(filled.halvings, filled.proposed.stopped, options, made.value());
  return made;
}

}  // namespace asterism::internal
