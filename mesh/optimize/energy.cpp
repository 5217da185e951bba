// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/vertex_hints.hpp"
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"

namespace asterism::internal::fitting {
namespace {

// Weights and margins, found by experiment (docs/design/fitting.md).
constexpr double weight_of_area = 0.05;
constexpr double weight_of_stars = 0.5;
constexpr double weight_below_bound = 200;
constexpr double far_margin = 0.1, subsegment_margin = 0.05;
constexpr double without_centre = 100;  // an edge of a triangle with no centre, times the weight
constexpr double most_angle_energy_at_sharp_corner = 1e3;
// Greatest squared distance of a centre, in areas wanted. A centre farther away is that of no
// triangle to be kept.
constexpr double farthest_centre = 120;

double angle_energy(double cotangent, const angle_targets& wanted) {
  const double excess = cotangent - wanted.cotangent;
  if (!(excess > 0)) return 0;
  const double square = excess * excess, beyond = std::max(0.0, cotangent - wanted.greatest);
  return square + 4 * square * square + weight_below_bound * beyond * beyond;
}

double margin_energy(double g, double margin) {
  const double h = (margin - g) / margin;
  return h > 0 ? weight_of_stars * (h * h + h) : 0;
}

}  // namespace

double fit_site::squared_distance(const point& q) const {
  const point u = seen(q.x - position.x, q.y - position.y);
  return u.x * u.x + u.y * u.y;
}

fit_site make_fit_site(const point& q, const metric_tensor& m, double log_area) {
  const double f11 = std::sqrt(m.m11);
  return {q, m, f11, m.m12 / f11, std::sqrt(least_across(m.m22, m.m12, m.m11)), log_area};
}

// Compares with 4 epsilon of the products, which covers the errors: differences, products and their
// difference are each rounded once.
bool surely_turns_left(const point& a, const point& b, const point& c) {
  constexpr double part = 4 * std::numeric_limits<double>::epsilon();
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  return left - right > part * (std::abs(left) + std::abs(right));
}

double metric_area(const fit_site& a, const fit_site& b, const fit_site& c) {
  const double twice = (b.position.x - a.position.x) * (c.position.y - a.position.y) -
                       (b.position.y - a.position.y) * (c.position.x - a.position.x);
  return (a.root_of_determinant() + b.root_of_determinant() + c.root_of_determinant()) * twice / 6;
}

double shape_energy(const fit_site& a, const fit_site& b, const fit_site& c,
                    const angle_targets& wanted, bool sharp) {
  if (!surely_turns_left(a.position, b.position, c.position))
    return std::numeric_limits<double>::infinity();
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y;
  const double wx = c.position.x - a.position.x, wy = c.position.y - a.position.y;
  const double twice_area = ux * wy - uy * wx;
  double angles = 0;
  for (const fit_site* from : {&a, &b, &c}) {
    const point u = from->seen(ux, uy), w = from->seen(wx, wy);
    const double across = 1 / (from->root_of_determinant() * twice_area);
    const double inner = u.x * w.x + u.y * w.y;
    angles += angle_energy(inner * across, wanted) +
              angle_energy((u.x * u.x + u.y * u.y - inner) * across, wanted) +
              angle_energy((w.x * w.x + w.y * w.y - inner) * across, wanted);
  }
  const double log_ratio =
      elementary::log(metric_area(a, b, c)) - (a.log_area + b.log_area + c.log_area) / 3;
  const double area = weight_of_area * log_ratio * log_ratio;
  if (!sharp) return angles + area;
  const double too_large = std::max(0.0, log_ratio);
  return 3 * too_large * too_large + 0.02 * std::min(angles, most_angle_energy_at_sharp_corner) +
         0.2 * area;
}

voronoi_centre find_centre(const fit_site& a, const fit_site& b, const fit_site& c) {
  const auto near = numeric::voronoi_vertex_near({a.position, a.metric}, {b.position, b.metric},
                                                 {c.position, c.metric});
  if (!near) return {};
  const point u = a.seen(near->x, near->y);
  const double squared_radius = u.x * u.x + u.y * u.y;
  if (!(squared_radius > 0 && squared_radius < farthest_centre * elementary::exp(a.log_area)))
    return {};
  return {{a.position.x + near->x, a.position.y + near->y}, squared_radius};
}

double far_site_energy(const voronoi_centre& centre, const fit_site& far) {
  if (centre.squared_radius < 0) return weight_of_stars * without_centre;
  return margin_energy(far.squared_distance(centre.position) / centre.squared_radius - 1,
                       far_margin);
}

double subsegment_energy(const voronoi_centre& centre, const point& a, const point& b,
                         const point& c) {
  if (centre.squared_radius < 0) return weight_of_stars * without_centre;
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double height = ux * (c.y - a.y) - uy * (c.x - a.x);
  const double inside = ux * (centre.position.y - a.y) - uy * (centre.position.x - a.x);
  return margin_energy(inside / height, subsegment_margin);
}

}  // namespace asterism::internal::fitting
