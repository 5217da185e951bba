// SPDX-License-Identifier: MIT
//
// Errors. Each value comes with `size`, at least the sum of its absolute monomials, and is off by
// less than 2^-48 of it in any rounding mode. Lengths and determinants are used only if the value
// is more than 2^-20 of the size, so that it is known to 2^-28 of itself; `narrowed` and `widened`
// cover that and the few operations that follow. In the range of numbers that is checked first,
// underflow takes less than that.
#include "asterism/mesh/audit/gap_reach.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/sized_value.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::audit_detail {
namespace {

constexpr double narrowed = 1 - 0x1p-20, widened = 1 + 0x1p-20, cross_error = 0x1p-46;

bool is_known(const sized_value& v) {
  return v.value > 0x1p-20 * v.size && v.value > 0x1p-300 && v.size < 0x1p300;
}

double cross(const point& a, const point& b) { return a.x * b.y - a.y * b.x; }

point apply(const metric_tensor& m, const point& u) {
  return {m.m11 * u.x + m.m12 * u.y, m.m12 * u.x + m.m22 * u.y};
}

// Returns u . dual with its size, at least the sum of its absolute monomials. `dual` is a metric of
// this trace, times a displacement of this extent.
sized_value inner_product(const point& u, const point& dual, double extent, double trace) {
  return {u.x * dual.x + u.y * dual.y, (std::abs(u.x) + std::abs(u.y)) * (extent * trace)};
}

// Returns the centre, relative to v, of the circle through all three sites in the sum of their
// metrics: any direction is a valid choice, that of the Voronoi vertex a good one.
point towards_vertex(const site& v, const site& x, const site& y, const point& to_x,
                     const point& to_y) {
  const metric_tensor &a = v.metric, &b = x.metric, &c = y.metric;
  const metric_tensor sum{a.m11 + b.m11 + c.m11, a.m12 + b.m12 + c.m12, a.m22 + b.m22 + c.m22};
  const point dual_x = apply(sum, to_x), dual_y = apply(sum, to_y);
  const double half_inverse = 0.5 / cross(dual_x, dual_y);
  const double long_x = half_inverse * (to_x.x * dual_x.x + to_x.y * dual_x.y),
               long_y = half_inverse * (to_y.x * dual_y.x + to_y.y * dual_y.y);
  return {long_x * dual_y.y - long_y * dual_x.y, long_y * dual_x.x - long_x * dual_y.x};
}

// A direction, with the square of its length as v measures.
struct measured_direction {
  point u;
  sized_value squared;
};

// Returns the lower bound of section 4.2 in the direction of u; 0 if it is not certainly
// positive, or the angle between u and the direction of z not certainly below 90 degrees.
double bound_beside(const site& v, const measured_ray& z, const measured_direction& to) {
  const point &u = to.u, &d = z.way;
  const metric_tensor &own = v.metric, &other = z.end->metric;
  if (!(inner_product(u, z.dual, z.extent, own.m11 + own.m22).below() > 0)) return 0;
  const double turned =
      std::abs(cross(u, d)) + cross_error * (std::abs(u.x * d.y) + std::abs(u.y * d.x));
  const double radicand = to.squared.value * narrowed - z.bend * (turned * turned) * widened;
  if (!(radicand > 0)) return 0;
  const double along =
      inner_product(u, apply(other, d), z.extent, other.m11 + other.m22).below() * z.inverse_c;
  const double bound =
      along - 0x1p-20 * std::abs(along) + std::sqrt(radicand) * z.inverse_root_c * narrowed;
  return bound > 0 ? bound : 0;
}

// Completes a ray whose end and `way` are set: adds the squares of its length in the metrics of
// both ends; `own` is v's metric.
void measure(measured_ray& ray, const metric_tensor& metric, double determinant, double own,
             double c, double other_determinant) {
  ray.is_known = true;
  ray.dual = apply(metric, ray.way);
  ray.extent = std::abs(ray.way.x) + std::abs(ray.way.y);
  ray.length = std::sqrt(own);
  ray.inverse_c = 1 / c;
  ray.inverse_root_c = std::sqrt(ray.inverse_c);
  ray.bend = std::max(other_determinant * ray.inverse_c, determinant / own) * widened;
  ray.share = 1 / (1 + ray.length * ray.inverse_root_c) * (widened * widened);
  ray.on_way = ray.length * ray.share * widened;
  ray.on_edge = std::max(ray.on_way, 0.5 * ray.length) * widened;
}

point minus(const point& a, const point& b) { return {a.x - b.x, a.y - b.y}; }

// Returns the reach and kite that follow from the lesser of the two lower bounds of section 4.2 in
// a direction; 0 is no bound.
gap_bound reach_of(const measured_direction& to, double bound, const measured_ray& x,
                   const measured_ray& y) {
  if (!(bound > 0)) return {infinity, {}};
  const double length = std::sqrt(to.squared.value) / bound * (widened * widened);
  return {std::max({length, x.on_edge, y.on_edge}), {{to.u.x / bound, to.u.y / bound}, length}};
}

}  // namespace

quick_reaches::quick_reaches(const site& v) : v_(v) {
  const sized_value determinant = sized_determinant(v.metric);
  determinant_ = determinant.value;
  is_known_ = is_known(determinant);
}

measured_ray quick_reaches::ray_to(const site& neighbour) const {
  measured_ray ray;
  ray.end = &neighbour;
  ray.way = minus(neighbour.position, v_.position);
  const sized_value own = sized_square_norm(v_.metric, ray.way),
                    c = sized_square_norm(neighbour.metric, ray.way),
                    determinant = sized_determinant(neighbour.metric);
  if (!(is_known_ && is_known(own) && is_known(c) && is_known(determinant))) return ray;
  measure(ray, v_.metric, determinant_, own.value, c.value, determinant.value);
  return ray;
}

gap_bound quick_reaches::between(const measured_ray& x, const measured_ray& y) const {
  if (!(x.is_known && y.is_known && cross(x.way, y.way) > 0)) return {infinity, {}};
  return along(towards_vertex(v_, *x.end, *y.end, x.way, y.way), x, y);
}

// Bounds the reach along the best of a few directions, found by bisecting the angle between the
// rays towards that with the smaller bound. Every direction gives a valid bound. Begins midway in
// v's metric, within a right angle of both rays. Ends where neither ray has a bound.
gap_bound quick_reaches::balanced(const measured_ray& x, const measured_ray& y) const {
  constexpr int steps = 5;
  gap_bound best{infinity, {}};
  if (!(x.is_known && y.is_known && cross(x.way, y.way) > 0)) return best;
  const double to_x = 1 / x.length, to_y = 1 / y.length;
  double t = 0.5;
  for (double step = 0.25; step > std::ldexp(0.25, -steps); step /= 2) {
    const double a = (1 - t) * to_x, b = t * to_y;
    const point u{a * x.way.x + b * y.way.x, a * x.way.y + b * y.way.y};
    const measured_direction to{u, sized_square_norm(v_.metric, u)};
    if (!is_known(to.squared)) break;
    const double beside_x = bound_beside(v_, x, to), beside_y = bound_beside(v_, y, to);
    if (!(std::max(beside_x, beside_y) > 0)) break;
    const gap_bound found = reach_of(to, std::min(beside_x, beside_y), x, y);
    if (found.vertex.length < best.vertex.length || !(best.reach < infinity)) best = found;
    t += beside_x > beside_y ? step : -step;
  }
  return best;
}

gap_bound quick_reaches::along(const point& u, const measured_ray& x, const measured_ray& y) const {
  const measured_direction to{u, sized_square_norm(v_.metric, u)};
  if (!is_known(to.squared)) return {infinity, {}};
  return reach_of(to, std::min(bound_beside(v_, x, to), bound_beside(v_, y, to)), x, y);
}

namespace {

// True only if bound_beside() is positive in the direction u, for the ray `way` to z: the factors
// of the ray are not divided.
bool is_bounded_beside(const site& v, double determinant, const site& z, const point& way,
                       const measured_direction& to) {
  const point& u = to.u;
  const sized_value own = sized_square_norm(v.metric, way), c = sized_square_norm(z.metric, way),
                    other = sized_determinant(z.metric);
  if (!(is_known(own) && is_known(c) && is_known(other))) return false;
  const double extent = std::abs(way.x) + std::abs(way.y);
  const auto is_ahead = [&](const metric_tensor& m) {
    return inner_product(u, apply(m, way), extent, m.m11 + m.m22).below() > 0;
  };
  if (!(is_ahead(v.metric) && is_ahead(z.metric))) return false;
  const double turned =
      std::abs(cross(u, way)) + cross_error * (std::abs(u.x * way.y) + std::abs(u.y * way.x));
  // Narrows by more than `narrowed` and the two `widened` of the radicand do.
  const double squared = to.squared.value * (1 - 0x1p-18), bent = turned * turned;
  return squared * c.value > other.value * bent && squared * own.value > determinant * bent;
}

}  // namespace

bool has_quick_reach(const site& v, const site& x, const site& y) {
  const point to_x = minus(x.position, v.position), to_y = minus(y.position, v.position);
  const sized_value determinant = sized_determinant(v.metric);
  if (!is_known(determinant) || !(cross(to_x, to_y) > 0)) return false;
  const point u = towards_vertex(v, x, y, to_x, to_y);
  const measured_direction to{u, sized_square_norm(v.metric, u)};
  return is_known(to.squared) && is_bounded_beside(v, determinant.value, x, to_x, to) &&
         is_bounded_beside(v, determinant.value, y, to_y, to);
}

}  // namespace asterism::internal::audit_detail
