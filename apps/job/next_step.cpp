// SPDX-License-Identifier: MIT
#include "asterism/apps/job/next_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/delivery/shortest_given_edge.hpp"

namespace asterism::apps {
namespace {
using internal::format_number;

// Angle bound, in degrees, that refinement reached in all tested domains without sharp corners.
constexpr double safe_bound = 20;

// Returns the number rounded up to two digits.
double in_two_digits(double x) {
  const double unit = internal::elementary::pow(10, std::floor(internal::elementary::log10(x)) - 1);
  return std::ceil(x / unit) * unit;
}

// Returns a limit on sites to try: with a size a fifth more than the estimated number. Without one,
// a bound that cannot be met may exceed any limit, so a lower bound is suggested first.
std::string more_sites(const mesh_job& job, const mesh_outcome& outcome) {
  const std::size_t limit = job.refinement.max_sites;
  if (!job.refinement.limit_size && job.refinement.angle_bound > safe_bound)
    return fmt::format("--angle-bound {:g}, or a larger --max-sites", safe_bound);
  if (!(outcome.ended.sites_wanted > 0))
    return fmt::format("--max-sites {}, or a {}", 10 * limit,
                       job.refinement.limit_size ? "larger --size" : "lower --angle-bound");
  const double wanted = 1.2 * outcome.ended.sites_wanted;
  if (wanted > 1e8) return "a larger --size";
  return fmt::format("--max-sites {:.0f}, or a larger --size", in_two_digits(wanted));
}

// Returns a limit on sites for some more steps of a guarantee: each step takes up to 1.69 times the
// sites of the one before.
std::string more_steps(const mesh_job& job) {
  constexpr std::size_t some_steps = 4;
  return fmt::format("--max-sites {}, or --gradation {:.3g}", some_steps * job.refinement.max_sites,
                     job.gradation ? 1 + (*job.gradation - 1) / 2 : 1.1);
}

std::string smoother(const mesh_job& job) {
  if (!job.gradation || *job.gradation > 1.2) return "--gradation 1.2, or a smaller --size";
  return fmt::format("--gradation {:.3g}, or a smaller --size", 1 + (*job.gradation - 1) / 2);
}

// Returns a bound to try. Narrow places that cannot be mended for one bound often can for half of
// it (water.poly: 70 triangles left at 20 degrees, none at 10); a bound below the worst angle
// leaves no bad triangle. A mesh without triangles has no worst angle.
std::string lower_bound(const mesh_job& job, const certified_mesh& made, const std::string& other) {
  const double bound =
      std::max(std::floor(job.refinement.angle_bound / 2), std::floor(made.report.worst().degrees));
  if (!(bound >= 1 && bound < job.refinement.angle_bound)) return other;
  return fmt::format("--angle-bound {:.0f}, or {}", bound, other);
}

// Returns the option that joins vertices a rounding apart; empty where there are none, or where
// domains of this kind are not repaired.
std::string repair(const mesh_job& job, const prepared_input& input, const mesh_outcome& outcome) {
  if (job.repair || input.of_mesh || !input.shape.curves.empty()) return "";
  const auto edge = internal::shortest_given_edge(outcome.result);
  if (!edge || !internal::is_rounding(*edge)) return "";
  return fmt::format("--repair-domain, which joins vertices {} and {}, {} apart", edge->a + 1,
                     edge->b + 1, format_number(edge->length));
}

bool has_one_metric(const mesh& m) {
  return std::all_of(m.sites.begin(), m.sites.end(),
                     [&m](const site& s) { return s.metric == m.sites.front().metric; });
}

// Returns the remedies for bad triangles that have no places for sites: first the options that keep
// sites away, then the domain, and the metric only if it varies.
std::string more_places(const mesh_job& job, const certified_mesh& made) {
  const mesh_options& asked = job.refinement;
  const mesh_outcome& outcome = made.outcome;
  if (asked.tolerance) return fmt::format("--tol {:.2g}, or none", *asked.tolerance / 8);
  if (asked.strategy != refinement_strategy::fill) return "--refine fill";
  if (!has_one_metric(outcome.result)) return smoother(job);
  if (outcome.ended.sharpest || outcome.one_metric)
    return lower_bound(job, made, "a domain without corners that sharp");
  return lower_bound(job, made, "a larger --size");
}

// Returns the remedy for a metric in which sites could not be spread: one that varies less, or is
// less thin.
std::string more_even(const mesh_job& job, const certified_mesh& made) {
  constexpr double thin = 1000;
  const auto& crowded = made.outcome.ended.crowded;
  if (!crowded || !crowded->has_one_metric) return more_places(job, made);
  const double aspect = job.sizes.aspect > thin ? thin : std::max(1.0, job.sizes.aspect / 10);
  return fmt::format("--aspect {:g}, or a metric that is less thin", aspect);
}

std::string more_time_or_memory(const mesh_job& job, const mesh_outcome& outcome) {
  constexpr double some_seconds = 60, some_megabytes = 1000;
  if (job.max_megabytes && outcome.ended.stopped_because.find("megabytes") != std::string::npos)
    return fmt::format("--max-memory {:g}, or a larger --size",
                       std::max(some_megabytes, 2 * *job.max_megabytes));
  if (!job.max_seconds) return "";
  return fmt::format("--max-seconds {:g}, or a larger --size",
                     std::max(some_seconds, 10 * *job.max_seconds));
}

}  // namespace

std::string next_step(const mesh_job& job, const prepared_input& input,
                      const certified_mesh& made) {
  const mesh_outcome& outcome = made.outcome;
  if (made.certified()) return job.refinement.prove_voronoi ? smoother(job) : "";
  const ending how = outcome.how();
  if (job.guarantee && how != ending::stopped) return more_steps(job);
  if (how != ending::complete && how != ending::stopped)
    if (std::string joined = repair(job, input, outcome); !joined.empty()) return joined;
  switch (how) {
    case ending::complete:
      return "";
    case ending::site_limit:
      return more_sites(job, outcome);
    case ending::one_metric:
      if (!outcome.one_metric->is_as_given) return smoother(job);
      return outcome.one_metric->has_demands ? more_sites(job, outcome) : more_places(job, made);
    case ending::collateral:
      return lower_bound(job, made, "a domain without corners that sharp");
    case ending::stopped:
      return more_time_or_memory(job, outcome);
    case ending::intolerable:
      // Rounds up, as the delivered metric depends a little on the tolerance.
      return fmt::format("--metric-tolerance {:g}, a smaller --size, or --gradation",
                         in_two_digits(outcome.intolerable->greatest));
    case ending::stuck:
    case ending::too_steep:
    case ending::overworked:
      return more_places(job, made);
    case ending::crowded:
      return more_even(job, made);
  }
  return "";
}

}  // namespace asterism::apps
