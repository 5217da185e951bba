// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/site_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/mesh/metric/feature_size_field.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/insertion_tolerance.hpp"

namespace asterism::internal {
namespace {

// Of the limit on sites, for the fill; the rest is for mending.
constexpr double part_for_filling = 0.8;
// Each attempt halves the sites at least once, and no problem takes 2^2000 of them.
constexpr int most_attempts = 2000;

// How many more times the number of sites is to be halved.
int halvings_for(double needed, std::size_t most_sites) {
  const double room = part_for_filling * static_cast<double>(most_sites);
  return std::max(1, static_cast<int>(std::ceil(std::log2(needed / room))));
}

double sites_on_segments(const mesh& m) {
  std::vector<char> on(m.sites.size(), 0);
  for (const boundary_edge& e : m.boundary) on[e.a] = on[e.b] = 1;
  return static_cast<double>(std::count(on.begin(), on.end(), 1));
}

// From so many vertices on, sites are spread as the segments will need them before anything else,
// unless that puts few inside: where a domain is narrow everywhere vertices see few others, and
// refinement finds fewer sites.
constexpr std::size_t many_vertices = 120, fewest_for_one_inside = 5;

// Every proposed site as the field, not the one it was spread by, measures there.
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

// The domain in `frame`, filled as the segments and, where that is limited, the size want it.
// Nothing where they want more sites than there may be.
using featured_filling = result<std::optional<filled_domain>>;
featured_filling fill_by_features(const domain& d, const metric_field& field, bool limit_size,
                                  fill_options wanted, const fill_progress& go_on) {
  const double longest = limit_size ? 1 : std::numeric_limits<double>::infinity();
  const auto featured = featured_field::make(d, field, longest);
  if (!featured) return featured.failure();
  wanted.is_uneven = true;
  auto proposed = fill(d, featured.value(), wanted, go_on);
  if (!proposed) return proposed.failure();
  if (!proposed.value().complete && !proposed.value().stopped)
    return featured_filling(std::nullopt);
  if (auto failure = measure_anew(field, proposed.value())) return *failure;
  return featured_filling(std::move(proposed).value());
}

}  // namespace

result<budgeted_filling> fill_within_budget(
    const unit_frame& frame, const domain& d, const metric_field& field,
    const mesh_options& options, const std::function<void(const mesh_progress&)>& progress) {
  budgeted_filling filled{{}, frame, 0};
  const bool is_large = d.vertices.size() >= many_vertices;
  if (options.strategy != refinement_strategy::fill || !(options.limit_size || is_large)) {
    filled.proposed.divisions.resize(d.segments.size());
    return filled;
  }
  fill_options wanted;
  wanted.distance = largest_circumradius;
  wanted.longest_subsegment = longest_subsegment_of_fill;
  wanted.max_sites = options.max_sites;
  if (options.stop) wanted.enough = [&options] { return options.stop().has_value(); };
  const auto go_on = [&](std::size_t sites, double needed) {
    mesh_progress now{mesh_phase::filling, sites, 0, 0, 0, 0};
    now.sites_expected = needed;
    if (progress) progress(now);
    return !options.stop || !options.stop();
  };
  if (is_large) {
    auto featured = frame.is_identity()
                        ? fill_by_features(d, field, options.limit_size, wanted, go_on)
                        : fill_by_features(frame.inward(d), framed_field(field, frame),
                                           options.limit_size, wanted, go_on);
    if (!featured) return featured.failure();
    const bool is_narrow =
        !options.limit_size && featured.value() && !featured.value()->stopped &&
        fewest_for_one_inside * featured.value()->interior.size() < d.vertices.size();
    if (featured.value() && !is_narrow) {
      filled.proposed = *std::move(featured).value();
      return filled;
    }
    if (!options.limit_size) {
      filled.proposed.divisions.resize(d.segments.size());
      return filled;
    }
  }
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    filled.frame = frame.length_factor(filled.halvings);
    auto proposed =
        filled.frame.is_identity()
            ? fill(d, field, wanted, go_on)
            : fill(filled.frame.inward(d), framed_field(field, filled.frame), wanted, go_on);
    if (!proposed) return proposed.failure();
    filled.proposed = std::move(proposed).value();
    if (filled.proposed.complete || filled.proposed.stopped || filled.proposed.crowded) break;
    filled.halvings += halvings_for(filled.proposed.needed, options.max_sites);
  }
  return filled;
}

void report_crowded(const budgeted_filling& filled, mesh_outcome& outcome) {
  const auto& crowded = filled.proposed.crowded;
  if (!crowded || outcome.complete) return;
  outcome.crowded = true;
  const point at = filled.frame.outward(crowded->where);
  outcome.reason = fmt::format(
      "the metric varies too fast for sites to be spread: of {} proposed, the one at ({}, {}) has "
      "{} neighbours (a gradation of it might do); only the given vertices are meshed",
      crowded->sites, format_number(at.x), format_number(at.y), crowded->neighbours);
}

void report_coarser(int halvings, bool fill_stopped, const mesh_options& options,
                    mesh_outcome& outcome) {
  if (halvings == 0) return;
  const mesh& m = outcome.result;
  outcome.complete = false;
  outcome.too_large = static_cast<std::size_t>(
      std::count_if(m.triangles.begin(), m.triangles.end(), [&m](const triangle& t) {
        return metric_circumradius({m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]}) >
               largest_circumradius;
      }));
  outcome.length_factor = std::exp2(halvings / 2.0);
  if (fill_stopped) {
    outcome.reason =
        fmt::format("the limit of {} sites was reached; with edges {:.3g} times as long, {}",
                    options.max_sites, outcome.length_factor, outcome.reason);
    return;
  }
  const double on_segments = sites_on_segments(m);
  const double inside = static_cast<double>(outcome.sites) - on_segments;
  outcome.sites_wanted =
      on_segments * outcome.length_factor + inside * outcome.length_factor * outcome.length_factor;
  outcome.reason = fmt::format(
      "the limit of {} sites was reached: the size wanted takes about {:.3g}; with edges {:.3g} "
      "times as long, {}",
      options.max_sites, outcome.sites_wanted, outcome.length_factor, outcome.reason);
}

}  // namespace asterism::internal
