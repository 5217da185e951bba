// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

#include "asterism/mesh/constructions.hpp"
#include "asterism/mesh/local/neighbourhood.hpp"
#include "asterism/mesh/refine_quality.hpp"

namespace asterism {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double arc_fraction = 0.2;
constexpr double arc_ladder = 1024;  // from start to floor
// After a fill, defects are mended at points nearly as far from all sites as the fill's own.
constexpr double fill_fraction = 0.6;
constexpr double fill_ladder = 128;  // from start to floor
constexpr double finest_part = 32;   // of start
constexpr double fill_shrink = 0.75;
constexpr double dart_fraction = 0.5;
constexpr double dart_ladder = 1024;

// Squared distance from s to the segment a b, as s measures it.
double squared_distance_to_segment(const site& s, const point& a, const point& b) {
  const point d{b.x - a.x, b.y - a.y}, e{s.position.x - a.x, s.position.y - a.y};
  const double t =
      std::clamp(inner_product(s.metric, d, e) / squared_length(s.metric, d), 0.0, 1.0);
  return squared_distance(s, {a.x + t * d.x, a.y + t * d.y});
}

double shortest_distance(const refine_state& state, double most) {
  const auto& sites = state.sites();
  double least = most * most;
  for (index v = 0; v < sites.size(); ++v) {
    for (index w = 0; w < sites.size(); ++w)
      if (w != v) least = std::min(least, squared_distance(sites[v], sites[w].position));
    for (const boundary_edge& p : state.edges().pieces())
      if (p.a != v && p.b != v)
        least = std::min(
            least, squared_distance_to_segment(sites[v], sites[p.a].position, sites[p.b].position));
  }
  return std::sqrt(least);
}

// The median over all sites of the distance to the nearest other one, as measured by both. Half
// the sites are crowded no more than this, so darts that far apart can land.
double median_distance(const refine_state& state, double most) {
  const auto& sites = state.sites();
  std::vector<double> nearest(sites.size(), most * most);
  for (index v = 0; v < sites.size(); ++v)
    for (index w = 0; w < sites.size(); ++w) {
      if (v == w) continue;
      const double d = squared_distance(sites[v], sites[w].position);
      nearest[v] = std::min(nearest[v], d);
      nearest[w] = std::min(nearest[w], d);
    }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(*middle);
}

// How near to each other the domain brings sites, as its vertices measure: the shortest distance
// from one to a site or to a piece not at it, and between the pieces at a sharp corner; at most
// `most`.
double smallest_feature(const refine_state& state, index vertices, double most) {
  const auto& sites = state.sites();
  const auto& pieces = state.edges().pieces();
  const site_oracle oracle = state.oracle();
  const neighbourhood& near = *oracle.near();
  double least = most * most;
  for (index v = 0; v < vertices; ++v) {
    const bounding_box box = box_around(sites[v], most);
    near.sites().visit_box(sites, box.low, box.high, [&](index w) {
      if (w != v) least = std::min(least, squared_distance(sites[v], sites[w].position));
      return true;
    });
    near.pieces().visit(box, [&](std::uint32_t i) {
      const auto& [a, b] = std::pair{pieces[i].a, pieces[i].b};
      if (a != v && b != v)
        least = std::min(
            least, squared_distance_to_segment(sites[v], sites[a].position, sites[b].position));
      return true;
    });
  }
  least = std::sqrt(least);
  // Beyond the first two pieces at a sharp corner the domain is about so wide.
  for (const domain_corner& c : state.corners())
    if (c.angle < 60)
      for (const std::size_t piece : state.pieces_at(c))
        least = std::min(least, state.piece_length(piece, c.vertex) * std::sin(c.angle * degree));
  return least;
}

}  // namespace

tolerance_range choose_tolerance(const refine_state& state, index vertices,
                                 const refinement_options& options) {
  const bool darts = options.strategy == refinement_strategy::poisson_darts;
  if (options.tolerance) {
    const double given = *options.tolerance;
    return {given, darts ? given / dart_ladder : given};
  }
  if (options.strategy == refinement_strategy::guaranteed && options.limit_size) {
    const double start = fill_fraction * largest_circumradius, finest = start / finest_part;
    return {start, std::min(start, smallest_feature(state, vertices, start)) / fill_ladder,
            fill_shrink, finest};
  }
  // With a size limit edges will be about 1 long, however far apart the given sites are.
  const double most = options.limit_size ? 1 : std::numeric_limits<double>::infinity();
  const double shortest = shortest_distance(state, most);
  if (darts) {
    const double start = dart_fraction * median_distance(state, most);
    return {start, std::min(start, shortest) / dart_ladder};
  }
  return {arc_fraction * shortest, arc_fraction * shortest / arc_ladder};
}

std::string format_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace asterism
