// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/site_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/mesh/metric/feature_size_field.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/coarser_mesh.hpp"
#include "asterism/mesh/refine/delaunay_prerefinement.hpp"

namespace asterism::internal {
namespace {

// Part of the limit on sites that the fill may use; the rest is for mending.
constexpr double part_for_filling = 0.8;
// Bound on the attempts. Each halves the sites at least once, and no problem takes 2^2000 of them.
constexpr int most_attempts = 2000;
// Limits for a first fill that follows the lengths of segments: the least number of vertices for
// which it is tried, and the greatest number of vertices for each site inside with which it is
// kept. In a domain that is narrow everywhere vertices see few others, and refinement without this
// fill takes fewer sites. Without a size limit only ends of segments count as vertices: isolated
// vertices are spread already.
constexpr std::size_t many_vertices = 120, fewest_for_one_inside = 5;

// Returns the number of further halvings of the number of sites that bring it within the limit.
int halvings_for(double needed, std::size_t most_sites) {
  const double room = part_for_filling * static_cast<double>(most_sites);
  return std::max(1, static_cast<int>(std::ceil(elementary::log2(needed / room))));
}

// Counts the vertices that are ends of segments.
std::size_t count_segment_ends(const domain& d) {
  std::vector<char> is_end(d.vertices.size(), 0);
  for (const segment& one : d.segments) is_end[one.a] = is_end[one.b] = 1;
  return static_cast<std::size_t>(std::count(is_end.begin(), is_end.end(), char{1}));
}

fill_options fill_options_for(const meshing_context& job) {
  const mesh_options& options = job.options;
  fill_options wanted;
  wanted.distance = largest_circumradius;
  wanted.longest_subsegment = longest_subsegment_of_fill;
  wanted.max_sites = options.max_sites;
  wanted.stop = options.stop;
  wanted.prescribed = job.prescribed;
  return wanted;
}

fill_progress progress_of(const meshing_context& job) {
  if (!job.progress) return {};
  return [&job](std::size_t sites, double needed) {
    mesh_progress now{mesh_phase::filling, sites, 0, 0, 0, 0};
    now.sites_expected = needed;
    job.progress(now);
  };
}

budgeted_filling nothing_proposed(const domain& d) {
  budgeted_filling nothing;
  nothing.proposed.divisions.resize(d.segments.size());
  return nothing;
}

// Replaces the metric of every proposed site by the field's own; it was spread by another one.
std::optional<error> measure_anew(const metric_field& field, filled_domain& proposed) {
  const auto measure = [&](std::vector<site>& sites) -> std::optional<error> {
    for (site& s : sites) {
      const auto metric = field.at(s.position);
      if (!metric) return metric.failure();
      s.metric = metric.value();
    }
    return std::nullopt;
  };
  for (std::vector<site>& division : proposed.divisions)
    if (auto failure = measure(division)) return failure;
  return measure(proposed.interior);
}

// Fills the domain for the lengths of its segments and, with a size limit, for the size. Returns
// nothing where that takes more sites than the limit or, without a size, where few of them would be
// inside.
result<std::optional<filled_domain>> fill_by_features(const meshing_context& job) {
  using filling = result<std::optional<filled_domain>>;
  const bool limit_size = job.options.limit_size;
  const double longest = limit_size ? 1 : std::numeric_limits<double>::infinity();
  const auto featured = featured_field::make(job.shape, job.field, longest);
  if (!featured) return featured.failure();
  fill_options wanted = fill_options_for(job);
  wanted.is_uneven = true;
  auto made = fill(job.shape, featured.value(), wanted, progress_of(job));
  if (!made) return made.failure();
  filled_domain& proposed = made.value();
  if (!proposed.complete && !proposed.stopped) return filling(std::nullopt);
  if (auto failure = measure_anew(job.field, proposed)) return *failure;
  const bool is_narrow =
      !limit_size && !proposed.stopped &&
      fewest_for_one_inside * proposed.interior.size() < job.shape.vertices.size();
  if (is_narrow) return filling(std::nullopt);
  return filling(std::move(proposed));
}

// Fills the domain for the size wanted, or with edges lengthened until the limit on sites is
// kept.
result<budgeted_filling> fill_by_halving(const meshing_context& job) {
  const fill_options wanted = fill_options_for(job);
  budgeted_filling filled;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const coarser_field coarser(job.field, filled.halvings);
    const metric_field& field =
        filled.halvings == 0 ? job.field : static_cast<const metric_field&>(coarser);
    auto proposed = fill(job.shape, field, wanted, progress_of(job));
    if (!proposed) return proposed.failure();
    filled.proposed = std::move(proposed).value();
    filled.work_units += filled.proposed.work_units;
    if (filled.proposed.complete || filled.proposed.stopped || filled.proposed.crowded) break;
    filled.halvings += halvings_for(filled.proposed.needed, job.options.max_sites);
  }
  return filled;
}

}  // namespace

result<budgeted_filling> fill_within_budget(const meshing_context& job) {
  const bool limit_size = job.options.limit_size;
  const std::size_t counted =
      limit_size ? job.shape.vertices.size() : count_segment_ends(job.shape);
  const bool is_large = counted >= many_vertices;
  if (job.options.strategy != refinement_strategy::fill || !(limit_size || is_large) ||
      is_refined_plainly(job.options, job.shape.vertices.size()))
    return nothing_proposed(job.shape);
  if (is_large) {
    auto featured = fill_by_features(job);
    if (!featured) return featured.failure();
    if (featured.value()) {
      const double units = featured.value()->work_units;
      return budgeted_filling{*std::move(featured).value(), 0, units};
    }
    if (!limit_size) return nothing_proposed(job.shape);
  }
  return fill_by_halving(job);
}

}  // namespace asterism::internal
