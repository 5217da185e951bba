// SPDX-License-Identifier: MIT
#include "asterism/apps/next_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"

namespace asterism::apps {
namespace {

// A fifth more than are wanted, since that is an estimate, in two digits.
std::string more_sites(const mesh_job& job, const mesh_outcome& outcome) {
  if (!job.refinement.limit_size) return "a lower --angle-bound, or a larger --max-sites";
  if (!(outcome.ended.sites_wanted > 0)) return "a larger --max-sites, or a larger --size";
  const double wanted = 1.2 * outcome.ended.sites_wanted;
  const double unit =
      internal::elementary::pow(10, std::floor(internal::elementary::log10(wanted)) - 1);
  if (wanted > 1e8) return "a larger --size";
  return fmt::format("--max-sites {:.0f}, or a larger --size", std::ceil(wanted / unit) * unit);
}

std::string smoother(const mesh_job& job) {
  if (!job.gradation || *job.gradation > 1.2) return "--gradation 1.2, or a smaller --size";
  return "a smaller --gradation, or a smaller --size";
}

// Returns a bound to try. Narrow places that cannot be mended for one bound often can for half of
// it (water.poly: 70 triangles left at 20 degrees, none at 10); below the worst angle nothing is
// left.
std::string lower_bound(const mesh_job& job, const certified_mesh& made) {
  const double bound =
      std::max(std::floor(job.refinement.angle_bound / 2), std::floor(made.report.worst().degrees));
  std::string other = "a domain without corners that sharp";
  if (!(bound >= 1)) return other;
  return fmt::format("--angle-bound {:.0f}, or {}", bound, other);
}

}  // namespace

std::string next_step(const mesh_job& job, const certified_mesh& made) {
  const mesh_outcome& outcome = made.outcome;
  if (made.certified())
    return job.refinement.prove_voronoi ? "a smaller --size, or --gradation 1.2" : "";
  switch (outcome.how()) {
    case ending::complete:
      return "";
    case ending::site_limit:
      return more_sites(job, outcome);
    case ending::one_metric:
      return outcome.one_metric->is_as_given ? more_sites(job, outcome) : smoother(job);
    case ending::collateral:
      return lower_bound(job, made);
    case ending::stopped:
      return job.max_megabytes &&
                     outcome.ended.stopped_because.find("megabytes") != std::string::npos
                 ? "a larger --max-memory, or a larger --size"
             : job.max_seconds ? "a larger --max-seconds, or a larger --size"
                               : "";
    case ending::intolerable:
      return fmt::format("--metric-tolerance {}, a smaller --size, or --gradation",
                         internal::number_text(outcome.intolerable->greatest));
    case ending::stuck:
    case ending::too_steep:
    case ending::overworked:
    case ending::crowded:
      return smoother(job);
  }
  return "";
}

}  // namespace asterism::apps
