// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/off_centre.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism::internal {
namespace {

// Returns the corner at which the shortest edge begins. Edges are compared by the sum of their
// squared lengths in the metrics of both ends.
std::size_t shortest_edge(const triangle_sites& s) {
  std::array<double, 3> length{};
  for (std::size_t i = 0; i < 3; ++i) {
    const site &p = s[i], &q = s[(i + 1) % 3];
    length[i] = squared_distance(p, q.position) + squared_distance(q, p.position);
  }
  return static_cast<std::size_t>(std::min_element(length.begin(), length.end()) - length.begin());
}

}  // namespace

std::optional<point> off_centre(const triangle_sites& s, double degrees, double radius) {
  const std::size_t first = shortest_edge(s);
  const site &p = s[first], &q = s[(first + 1) % 3];
  const metric_tensor m{(p.metric.m11 + q.metric.m11) / 2, (p.metric.m12 + q.metric.m12) / 2,
                        (p.metric.m22 + q.metric.m22) / 2};
  const point d{q.position.x - p.position.x, q.position.y - p.position.y};
  const double root = std::sqrt(m.m11 * m.m22 - m.m12 * m.m12);
  // Returns the vector orthogonal to d in the metric m, of the same length, to its left.
  const point across{-(m.m12 * d.x + m.m22 * d.y) / root, (m.m11 * d.x + m.m12 * d.y) / root};
  const double height = 0.5 / elementary::tan(degrees / 2 * std::numbers::pi / 180);
  if (!(height * std::sqrt(inner_product(m, d, d)) < radius)) return std::nullopt;
  return point{p.position.x + d.x / 2 + height * across.x,
               p.position.y + d.y / 2 + height * across.y};
}

std::optional<site> find_off_centre(refine_state& state, const triangle& t, double degrees,
                                    double tolerance) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return std::nullopt;
  const auto& sites = state.sites();
  const triangle_sites corners{sites[t[0]], sites[t[1]], sites[t[2]]};
  const auto q = off_centre(corners, degrees, metric_circumradius(corners));
  if (!q || !state.strictly_inside(*q)) return std::nullopt;
  const auto s = state.site_at(*q);
  if (!s || !state.is_farther(*s, tolerance) || !state.encroached_by(*s).empty())
    return std::nullopt;
  return s;
}

}  // namespace asterism::internal
