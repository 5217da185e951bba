// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/steepness.hpp"

#include <algorithm>

#include "asterism/mesh/numerics/mesh_statistics.hpp"

namespace asterism::internal {
namespace {

// Greatest sigma * distance with which refinement reached 20 degrees in experiments; the proof
// requires 0.052 (docs/math/refinement.md). A triangle beyond it is given up, so the greater number
// is used.
constexpr double resolved_variation = 0.3;
// Distortion below which two sites have wedged arcs at any distance that sites of a net can have:
// the square root of the golden ratio (docs/math/refinement.md, point 4).
constexpr double resolved_distortion = 1.272;

}  // namespace

bool steepness::gives_up(const bad_triangle& b) {
  if (options_.strategy != refinement_strategy::fill) return false;
  // Judges only disagreeing triangles where no size is limited: large ones have another metric at
  // every corner.
  if (!options_.limit_size && b.why != badness::disagreeing) return false;
  const bool beside = b.why != badness::too_large && !at_jump_.empty() &&
                      std::any_of(b.where.begin(), b.where.end(),
                                  [this](vertex_index v) { return at_jump_.count(v) != 0; });
  if (!beside && !is_too_steep(b.where)) return false;
  if (given_up_.empty()) sites_at_first_ = state_.sites().size();
  if (!beside) at_jump_.insert(b.where.begin(), b.where.end());
  if (b.why == badness::disagreeing) jump_disagrees_ = true;
  given_up_.insert(b.where);
  return true;
}

bool steepness::has_waited_enough() const {
  constexpr std::size_t at_least = 1000;
  return !given_up_.empty() &&
         state_.sites().size() > sites_at_first_ + std::max(at_least, sites_at_first_ / 16);
}

std::optional<steep_place> steepness::first_place(const std::set<bad_triangle>& bad) const {
  std::optional<steep_place> place;
  for (const bad_triangle& b : bad) {
    if (!is_given_up(b.where)) continue;
    if (!place) place = {0, state_.sites()[b.where[0]].position, finest_};
    ++place->triangles;
  }
  return place;
}

// True if the metric varies faster than sites at the floor could resolve: there are no defects
// where sigma times the distance of sites is small (docs/math/refinement.md).
bool steepness::is_too_steep(const triangle& t) {
  const auto metric = [&](std::size_t i) -> const metric_tensor& {
    return state_.sites()[t[i]].metric;
  };
  if (identical(metric(0), metric(1)) && identical(metric(0), metric(2))) return false;
  const double most = resolved_variation / finest_;
  const triangle_sites sites = sites_of(state_, t);
  for (std::size_t i = 0; i < 3; ++i)
    if (t[i] != t[(i + 1) % 3] && steepest_between(sites[i], sites[(i + 1) % 3], most) > most)
      return true;
  return false;
}

// Returns the greatest variation of the metric found between p and q. Follows the half over which
// the metric changes more, down to the least distance of sites.
double steepness::steepest_between(site p, site q, double enough) {
  double steepest = variation(p, q);
  while (steepest <= enough && distortion(p.metric, q.metric) > resolved_distortion) {
    const auto middle = state_.site_at({p.position.x + (q.position.x - p.position.x) / 2,
                                        p.position.y + (q.position.y - p.position.y) / 2});
    if (!middle || middle->position == p.position || middle->position == q.position) break;
    const bool first = distortion(p.metric, middle->metric) >= distortion(middle->metric, q.metric);
    (first ? q : p) = *middle;
    steepest = std::max(steepest, variation(p, q));
  }
  return steepest;
}

}  // namespace asterism::internal
