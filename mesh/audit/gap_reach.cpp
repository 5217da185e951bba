// SPDX-License-Identifier: MIT
//
// Errors. Each value comes with `size`, at least the sum of its absolute monomials, and is off by
// less than 2^-48 of it in any rounding mode. Of lengths and determinants the value is asked to be
// more than 2^-20 of the size, so that it is known to 2^-28 of itself; `narrowed` and `widened`
// cover that and the few operations that follow. In the range asked for underflows are less.
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

// Returns the product of u with the dual by a metric, of this trace, of a way of this extent, and
// at least the sum of its absolute monomials.
sized_value inner_product(const point& u, const point& dual, double extent, double trace) {
  return {u.x * dual.x + u.y * dual.y, (std::abs(u.x) + std::abs(u.y)) * (extent * trace)};
}

// Returns the centre, from v, of the circle that the sum of the three metrics sees through all of
// them: any direction is a valid choice, that of the Voronoi vertex a good one.
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

// Returns u, from v, after one step of Newton's method towards where all three are equally far.
point nearer_to_vertex(const site& v, const site& x, const site& y, const point& to_x,
                       const point& to_y, const point& u) {
  const point from_x{u.x - to_x.x, u.y - to_x.y}, from_y{u.x - to_y.x, u.y - to_y.y};
  const point own = apply(v.metric, u), by_x = apply(x.metric, from_x),
              by_y = apply(y.metric, from_y);
  const double square = u.x * own.x + u.y * own.y;
  const double excess_x = 0.5 * (square - (from_x.x * by_x.x + from_x.y * by_x.y)),
               excess_y = 0.5 * (square - (from_y.x * by_y.x + from_y.y * by_y.y));
  const point slope_x{by_x.x - own.x, by_x.y - own.y}, slope_y{by_y.x - own.x, by_y.y - own.y};
  const double inverse = 1 / cross(slope_x, slope_y);
  const point nearer{u.x + inverse * (excess_x * slope_y.y - excess_y * slope_x.y),
                     u.y + inverse * (excess_y * slope_x.x - excess_x * slope_y.x)};
  return std::abs(nearer.x) + std::abs(nearer.y) < infinity ? nearer : u;
}

// A direction, with the square of its length as v measures.
struct measured_direction {
  point u;
  sized_value squared;
};

// Holds what z contributes to R, and a bound from below of b_z(u); nothing known: infinite and 0.
struct side_of_gap {
  double reach = infinity, bound = 0;
};

// Knows nothing where the bound of 4.2 is not certainly positive, or u not certainly within a right
// angle of z.
side_of_gap beside(const site& v, const measured_ray& z, const measured_direction& to) {
  const point &u = to.u, &d = z.way;
  const metric_tensor &own = v.metric, &other = z.end->metric;
  if (!(inner_product(u, z.dual, z.extent, own.m11 + own.m22).below() > 0)) return {};
  const double turned =
      std::abs(cross(u, d)) + cross_error * (std::abs(u.x * d.y) + std::abs(u.y * d.x));
  const double radicand = to.squared.value * narrowed - z.bend * (turned * turned) * widened;
  if (!(radicand > 0)) return {};
  const double along =
      inner_product(u, apply(other, d), z.extent, other.m11 + other.m22).below() * z.inverse_c;
  const double bound =
      along - 0x1p-20 * std::abs(along) + std::sqrt(radicand) * z.inverse_root_c * narrowed;
  if (!(bound > 0)) return {};
  return {std::max(std::sqrt(to.squared.value) / bound, z.on_edge) * (widened * widened), bound};
}

// Adds to the ray, whose end and way are set, what the square of its length is as both ends
// measure, `own` from v.
void measure(measured_ray& ray, const metric_tensor& metric, double determinant, double own,
             double c, double other_determinant) {
  ray.is_known = true;
  ray.dual = apply(metric, ray.way);
  ray.extent = std::abs(ray.way.x) + std::abs(ray.way.y);
  ray.length = std::sqrt(own);
  ray.inverse_c = 1 / c;
  ray.inverse_root_c = std::sqrt(ray.inverse_c);
  ray.bend = std::max(other_determinant * ray.inverse_c, determinant / own) * widened;
  ray.on_edge = std::max(ray.length / (1 + ray.length * ray.inverse_root_c), 0.5 * ray.length);
}

point minus(const point& a, const point& b) { return {a.x - b.x, a.y - b.y}; }

// A cross product from below and from above; each monomial passes few roundings.
double cross_below(const point& a, const point& b) {
  return cross(a, b) - cross_error * (std::abs(a.x * b.y) + std::abs(a.y * b.x));
}
double cross_above(const point& a, const point& b) {
  return cross(a, b) + cross_error * (std::abs(a.x * b.y) + std::abs(a.y * b.x));
}

// Returns the direction, or that of the ray which it is beyond: there the bisector of the other
// neighbour is met no later than the circumcentre of an obtuse triangle is.
point between_rays(const point& u, const point& x, const point& y) {
  return cross(x, u) < 0 ? x : cross(u, y) < 0 ? y : u;
}

gap_extent extent_of(const site& v, const measured_ray& x, const measured_ray& y, const point& u) {
  const measured_direction to{u, sized_square_norm(v.metric, u)};
  if (!is_known(to.squared)) return {};
  const side_of_gap by_x = beside(v, x, to), by_y = beside(v, y, to);
  const double bound = std::min(by_x.bound, by_y.bound);
  if (!(bound > 0)) return {};
  const double along = cross_above(x.way, u) + cross_above(u, y.way), inverse = 1 / bound;
  return {by_x.reach > by_y.reach ? by_x.reach : by_y.reach,
          {inverse * u.x, inverse * u.y},
          cross_below(x.way, y.way) * bound * narrowed >= along};
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

double quick_reaches::between(const measured_ray& x, const measured_ray& y) const {
  if (!(x.is_known && y.is_known && cross(x.way, y.way) > 0)) return infinity;
  const point u = towards_vertex(v_, *x.end, *y.end, x.way, y.way);
  return extent_of(v_, x, y, u).reach;
}

bool is_in_triangle_behind(const gap_extent& gap, const site& v, const site& x, const site& y,
                           const site& behind) {
  const point to_x = minus(x.position, v.position), to_y = minus(y.position, v.position),
              to_d = minus(behind.position, v.position);
  // Bounds what the tip is off by, and the way back from it.
  const double extent = std::abs(gap.tip.x) + std::abs(gap.tip.y);
  const auto is_left_of = [&](const point& from, const point& to) {
    const point along = minus(to, from), way = minus(gap.tip, from);
    const double slack = 0x1p-18 * (std::abs(along.x) + std::abs(along.y)) *
                         (extent + std::abs(from.x) + std::abs(from.y));
    return cross(along, way) > slack;
  };
  return gap.reach < infinity && is_left_of(to_x, to_d) && is_left_of(to_d, to_y);
}

std::array<gap_extent, 3> extents_of(const std::array<const site*, 3>& corners) {
  std::array<gap_extent, 3> extents;
  std::array<double, 3> determinants;
  std::array<measured_ray, 3> onwards, back;  // to the next corner, and from that
  for (std::size_t i = 0; i < 3; ++i) {
    const sized_value determinant = sized_determinant(corners[i]->metric);
    if (!is_known(determinant)) return extents;
    determinants[i] = determinant.value;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const site &p = *corners[i], &q = *corners[next];
    onwards[i].end = &q;
    onwards[i].way = minus(q.position, p.position);
    back[i].end = &p;
    back[i].way = {-onwards[i].way.x, -onwards[i].way.y};
    const sized_value by_p = sized_square_norm(p.metric, onwards[i].way),
                      by_q = sized_square_norm(q.metric, onwards[i].way);
    if (!(is_known(by_p) && is_known(by_q))) return extents;
    measure(onwards[i], p.metric, determinants[i], by_p.value, by_q.value, determinants[next]);
    measure(back[i], q.metric, determinants[next], by_q.value, by_p.value, determinants[i]);
  }
  const site &a = *corners[0], &b = *corners[1], &c = *corners[2];
  const point &to_b = onwards[0].way, &to_c = back[2].way;
  const point u = nearer_to_vertex(a, b, c, to_b, to_c, towards_vertex(a, b, c, to_b, to_c));
  const std::array<point, 3> from_corners = {u, minus(u, onwards[0].way), minus(u, back[2].way)};
  for (std::size_t i = 0; i < 3; ++i) {
    const measured_ray &x = onwards[i], &y = back[(i + 2) % 3];
    extents[i] = extent_of(*corners[i], x, y, between_rays(from_corners[i], x.way, y.way));
  }
  return extents;
}

}  // namespace asterism::internal::audit_detail
