// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/metric_angle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"

namespace asterism::internal {

namespace {

// Returns the direction from p to q, scaled so that its largest component is 1: no product of two
// overflows. Halves the coordinates first, for ends at opposite extremes.
point direction(const point& p, const point& q) {
  const point d{q.x / 2 - p.x / 2, q.y / 2 - p.y / 2};
  const double scale = std::max(std::abs(d.x), std::abs(d.y));
  return {d.x / scale, d.y / scale};
}

}  // namespace

double angle_in_metric(const metric_tensor& m, const point& corner, const point& p,
                       const point& q) {
  const double scale = std::max({std::abs(m.m11), std::abs(m.m12), std::abs(m.m22)});
  const metric_tensor n{m.m11 / scale, m.m12 / scale, m.m22 / scale};
  const point a = direction(corner, p), b = direction(corner, q);
  const double inner = a.x * (n.m11 * b.x + n.m12 * b.y) + a.y * (n.m12 * b.x + n.m22 * b.y);
  const double determinant = std::max(0.0, n.m11 * n.m22 - n.m12 * n.m12);
  const double area = std::sqrt(determinant) * std::abs(a.x * b.y - a.y * b.x);
  return elementary::atan2(area, inner) * (180 / std::numbers::pi);
}

double smallest_angle(const mesh& m, const triangle& t) {
  const triangle_sites round = in_round_coordinates({m.sites[t[0]], m.sites[t[1]], m.sites[t[2]]});
  double least = std::numeric_limits<double>::infinity();
  for (const site& from : round)
    for (std::size_t corner = 0; corner < 3; ++corner)
      least = std::min(least, angle_in_metric(from.metric, round[corner].position,
                                              round[(corner + 1) % 3].position,
                                              round[(corner + 2) % 3].position));
  return least;
}

}  // namespace asterism::internal
