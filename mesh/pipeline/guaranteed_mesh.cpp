// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/guaranteed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "asterism/core/number_text.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/theorem_hypotheses.hpp"
#include "asterism/mesh/audit/theorem_table.hpp"
#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/delivery/normalised_problem.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/fill/net_completion.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/pipeline/guarantee_hypotheses.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/pipeline/shorter_field.hpp"
#include "asterism/mesh/refine/mesh_domain.hpp"
#include "asterism/mesh/stars/work_limit.hpp"
#include "asterism/mesh/support/size_ladder.hpp"

namespace asterism {
using namespace internal;
namespace {

// Least metric distance from all others of a site that mends a triangle: it leaves the covering
// radius of 0.75 below 1.1 times the spacing, for which the table proves 26.75 degrees at small
// variation.
constexpr double guaranteed_spacing = 0.69;

// Returns the greatest variation in the table for which the angle bound is proved of sites whose
// spacing equals their covering radius.
double greatest_variation(double angle_bound) {
  double greatest = 0;
  for (std::size_t i = 0; i < theorem::variations.size(); ++i)
    if (theorem::proved_angles[i][0] >= angle_bound) greatest = theorem::variations[i];
  return greatest;
}

// Returns the last step of the ladder whose edges are no shorter than the samples of the field
// demand. Edges longer than demanded may suffice, since there may be no site where the field is
// steepest. A step from an upper bound of the field could be finer than needed.
int first_step(const field_steepness& field, double angle_bound) {
  return ladder_step_below(field.sampled * largest_circumradius / greatest_variation(angle_bound));
}

// Part of the greatest radius of a triangle within which sites are to cover the domain: the
// remainder allows for roundings of radii, and for the variation of the metric across a triangle.
constexpr double part_covered = 1 - 0x1p-10;

// Least and greatest length wanted of the parts of a segment, metric length.
struct part_lengths {
  double shortest = 0, longest = 0;
};

// Returns the lengths for a domain with this narrowest corner. Beside a sharp corner longer parts
// keep sites farther from each other. A part of 1.27 times the covering radius, shifted by a 64th,
// is not encroached on by a site that is at least 0.92 times the radius from both of its ends.
part_lengths lengths_for(double narrowest_corner) {
  constexpr double beside_sharp_corners = 1.27 * largest_circumradius;
  if (narrowest_corner < least_plain_corner) return {beside_sharp_corners, beside_sharp_corners};
  return {largest_circumradius, longest_subsegment_of_fill};
}

// Returns the points that divide the segments by metric length, ends left out; nothing where there
// would be more than `most`.
result<prescribed_divisions> even_divisions(const domain& d, const metric_field& field,
                                            const part_lengths& parts, std::size_t most) {
  const auto made = divide_segments_evenly(d, field, parts.shortest, parts.longest, most);
  if (!made) return made.failure();
  prescribed_divisions divisions(d.segments.size());
  for (std::size_t s = 0; s < made.value().of_each.size(); ++s) {
    const std::vector<point>& all = made.value().of_each[s].points;
    divisions[s].emplace(all.begin() + 1, all.end() - 1);
  }
  return divisions;
}

fill_options fill_options_of(const meshing_context& job) {
  fill_options wanted;
  wanted.distance = largest_circumradius;
  wanted.longest_subsegment = longest_subsegment_of_fill;
  wanted.max_sites = job.options.max_sites;
  wanted.stop = job.options.stop;
  wanted.prescribed = job.prescribed;
  return wanted;
}

// Fills the job's domain, completes the fill to a net, and mends that: where the theorem on nets
// applies to the net there is nothing to mend. An unfinished fill is no net, and is mended like any
// other fill.
result<mesh_outcome> mesh_of_net(const meshing_context& job) {
  auto filled = fill(job.shape, job.field, fill_options_of(job), [&](std::size_t sites, double) {
    if (job.progress) job.progress({mesh_phase::filling, sites, 0, 0, 0, 0});
  });
  if (!filled) return filled.failure();
  filled_domain& proposed = filled.value();
  if (!proposed.complete) return mesh_domain(job);
  const auto net = complete_net(job.shape, job.field,
                                {.covering = part_covered * largest_circumradius,
                                 .spacing = guaranteed_spacing,
                                 .max_sites = job.options.max_sites,
                                 .stop = job.options.stop},
                                proposed);
  if (!net) return net.failure();
  const double units = proposed.work_units;
  return mesh_from_sites(job, {std::move(proposed), 0, units});
}

mesh_options options_of_step(const mesh_options& asked) {
  mesh_options options = asked;
  options.strategy = refinement_strategy::fill;
  options.tolerance = guaranteed_spacing;
  options.limit_size = true;
  options.improve_passes = 0;
  options.keep_if_complete = false;
  options.metric_tolerance = 0;
  options.stop = with_run_work(asked.stop);
  return options;
}

// Makes a mesh in the metric of `field` with edges shortened by the factor of the step.
result<mesh_outcome> mesh_of_step(const domain& d, const metric_field& field,
                                  const mesh_options& asked, int step, const part_lengths& parts,
                                  const progress_listener& progress) {
  const mesh_options options = options_of_step(asked);
  options.stop.expect(d.vertices.size());
  const shorter_field finer(field, ladder_factor(step));
  const normalised_problem image(d, finer, options);
  const auto divisions = even_divisions(image.shape(), image.field(), parts, options.max_sites);
  if (!divisions) return divisions.failure();
  tier_counters decided;
  const star_predicates_on<filtered_kernel> stars_on(decided);
  auto made = mesh_of_net({stars_on, image.shape(), image.field(), options, progress, 1,
                           star_confirmation::by_mesher, &divisions.value()});
  if (!made) return made;
  mesh_outcome& outcome = made.value();
  image.outward(outcome);
  if (const auto failure = finer.restore(outcome)) return *failure;
  outcome.counters = decided;
  assign_regions(outcome.result, d);
  return made;
}

// The mesh of one step, and why the theorem does not apply to it; empty if it does.
struct step_taken {
  mesh_outcome outcome;
  int step = 0;
  std::string obstacle;
};

bool is_beyond_limit(const mesh_outcome& made) { return made.how() == ending::site_limit; }

// Makes the outcome state that the guarantee is not kept, why, and how far the run came.
certified_mesh without_guarantee(certified_mesh judged, int step, const std::string& why) {
  judged.outcome.complete = false;
  judged.claim.complete = false;
  judged.claim.reason = "no guarantee: with edges " + format_number(ladder_factor(step)) +
                        " times shorter than asked for, and " +
                        std::to_string(judged.outcome.sites) + " sites, " + why;
  return judged;
}

// Climbs the ladder of sizes until the theorem applies.
class size_ladder {
 public:
  size_ladder(const domain& d, const metric_field& field, const mesh_options& options,
              const progress_listener& progress, const field_steepness& steepness)
      : domain_(d), field_(field), options_(options), progress_(progress), steepness_(steepness) {}

  result<certified_mesh> run() {
    const part_lengths parts = lengths_for(steepness_.narrowest_corner);
    for (int step = first_step(steepness_, options_.angle_bound);; ++step) {
      auto made = mesh_of_step(domain_, field_, options_, step, parts, progress_);
      if (!made) return made.failure();
      step_taken now{std::move(made).value(), step, {}};
      now.obstacle = obstacle_of(now.outcome, ladder_factor(step));
      if (now.obstacle.empty()) {
        certified_mesh judged = judge(now);
        if (is_kept(judged)) return guaranteed(std::move(judged), step);
        now.obstacle = "the audit refuses it";
      }
      if (is_beyond_limit(now.outcome) || now.outcome.stopped || step >= ladder_steps)
        return ended(std::move(now));
      if (now.outcome.complete || !last_) last_ = std::move(now);
    }
  }

 private:
  // Returns why the theorem does not apply, empty if it does.
  std::string obstacle_of(const mesh_outcome& outcome, double factor) const {
    if (!outcome.complete) return "the run ended: " + ending_text(outcome);
    const theorem_hypotheses h =
        measure_theorem_hypotheses(outcome.result, options_.angle_bound, options_.stop);
    if (!h.applies) return "the theorem on nets does not apply: " + h.reason;
    if (h.covering_radius * factor <= guaranteed_covering) return "";
    return "the domain is covered within " + format_number(h.covering_radius) + " alone";
  }

  // Audits the mesh of a step and enters the factor by which its edges are shorter.
  certified_mesh judge(const step_taken& taken) const {
    mesh_outcome outcome = taken.outcome;
    outcome.ended.length_factor = 1 / ladder_factor(taken.step);
    if (progress_) progress_({.phase = mesh_phase::auditing, .sites = outcome.sites});
    return judge_outcome(std::move(outcome), domain_, options_);
  }

  static bool is_kept(const certified_mesh& judged) {
    return judged.certified() && judged.claim.theorem && judged.claim.theorem->applies;
  }

  certified_mesh guaranteed(certified_mesh judged, int step) const {
    judged.claim.guarantee = guarantee_of(*judged.claim.theorem, ladder_factor(step),
                                          steepness_.sampled, steepness_.bound);
    return judged;
  }

  // Returns the last complete mesh if there is one, else the one that ended the ladder.
  certified_mesh ended(step_taken now) {
    if (!last_ || !last_->outcome.complete || now.outcome.complete)
      return without_guarantee(judge(now), now.step, now.obstacle);
    return without_guarantee(judge(*last_), last_->step,
                             last_->obstacle + "; with edges " +
                                 format_number(ladder_factor(now.step)) + " times shorter " +
                                 now.obstacle);
  }

  const domain& domain_;
  const metric_field& field_;
  const mesh_options& options_;
  const progress_listener& progress_;
  const field_steepness steepness_;
  std::optional<step_taken> last_;  // the last complete one, if there is one
};

}  // namespace

result<certified_mesh> make_guaranteed_mesh(const domain& d, const metric_field& field,
                                            const mesh_options& options,
                                            const progress_listener& progress) {
  if (auto refused = check_options(d, options)) return *refused;
  field_steepness steepness;
  if (auto refused = refused_guarantee(d, field, options, steepness)) return *refused;
  return size_ladder(d, field, options, progress, steepness).run();
}

}  // namespace asterism
