// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/poisson_darts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"

namespace asterism::internal {
namespace {

constexpr double shrink = 0.8;
constexpr double reach = 1.5;  // of the ellipse, in distances from centroid to farthest vertex

}  // namespace

point throw_dart(const refine_state& state, const triangle& t, splitmix64& random) {
  const triangle_sites sites = sites_of(state, t);
  site mean{};
  for (const site& s : sites) {
    mean.position.x += s.position.x / 3;
    mean.position.y += s.position.y / 3;
    mean.metric.m11 += s.metric.m11 / 3;
    mean.metric.m12 += s.metric.m12 / 3;
    mean.metric.m22 += s.metric.m22 / 3;
  }
  double farthest = 0;
  for (const site& s : sites) farthest = std::max(farthest, squared_distance(mean, s.position));
  const double radius = reach * std::sqrt(farthest * random.real());
  const double turn = 2 * std::numbers::pi * random.real();
  // Draws from an ellipse: with M = L L^T, the points c + L^-T u, |u| = r, are those at distance r
  // from c.
  const double l11 = std::sqrt(mean.metric.m11), l21 = mean.metric.m12 / l11;
  const double l22 = std::sqrt(least_across(mean.metric.m22, mean.metric.m12, mean.metric.m11));
  const double y = radius * elementary::sin(turn) / l22;
  const double x = (radius * elementary::cos(turn) - l21 * y) / l11;
  return {mean.position.x + x, mean.position.y + y};
}

bool dart_thrower::refine(refine_state& state, const std::vector<bad_triangle>& bad,
                          std::size_t& rejected) {
  while (true) {
    const triangle& t = bad[turn_++ % bad.size()].where;
    if (place_site(state, throw_dart(state, t, random_), tolerance_) ==
        placement_outcome::inserted) {
      rejected_in_a_row_ = 0;
      return true;
    }
    ++rejected;
    if (state.field_failure()) return false;
    if (++rejected_in_a_row_ < max_rejected_) continue;
    rejected_in_a_row_ = 0;
    if (tolerance_ <= floor_) return false;
    tolerance_ = std::max(floor_, shrink * tolerance_);
  }
}

}  // namespace asterism::internal
