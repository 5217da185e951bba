// SPDX-License-Identifier: MIT
//
// Errors. Each value comes with `size`, at least the sum of its absolute monomials, and is off by
// less than 2^-48 of it in any rounding mode. Of lengths and determinants the value is asked to be
// more than 2^-20 of the size, so that it is known to 2^-28 of itself; `down` and `up` cover that
// and the few operations that follow. In the range asked for underflows are less.
#include "asterism/mesh/audit/gap_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/mesh/audit/sized_value.hpp"

namespace asterism::internal::audit_detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double down = 1 - 0x1p-20, up = 1 + 0x1p-20, step = 0x1p-46;

bool is_known(const sized_value& v) {
  return v.value > 0x1p-20 * v.size && v.value > 0x1p-300 && v.size < 0x1p300;
}

double cross(const point& a, const point& b) { return a.x * b.y - a.y * b.x; }

point between(const site& from, const site& to) {
  return {to.position.x - from.position.x, to.position.y - from.position.y};
}

point apply(const metric_tensor& m, const point& u) {
  return {m.m11 * u.x + m.m12 * u.y, m.m12 * u.x + m.m22 * u.y};
}

sized_value inner_product(const metric_tensor& m, const point& u, const point& d) {
  const point dual = apply(m, d);
  return {u.x * dual.x + u.y * dual.y,
          (std::abs(u.x) + std::abs(u.y)) * ((std::abs(d.x) + std::abs(d.y)) * (m.m11 + m.m22))};
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

// Returns the greatest of what z contributes to R, for the direction u of length |u|_v; infinite
// where the bound of 4.2 is not certainly positive, or u not certainly within a right angle of z.
double reach_beside(const site& v, const site& z, const point& d, const point& u,
                    const sized_value& u_squared, const sized_value& det_v) {
  const sized_value own = sized_square_norm(v.metric, d), c = sized_square_norm(z.metric, d),
                    det_z = sized_determinant(z.metric);
  if (!(is_known(own) && is_known(c) && is_known(det_z))) return infinity;
  if (!(inner_product(v.metric, u, d).below() > 0)) return infinity;
  const double inverse_c = 1 / c.value, root_own = std::sqrt(own.value),
               inverse_root_c = std::sqrt(inverse_c);
  const double bend = std::max(det_z.value * inverse_c, det_v.value / own.value) * up;
  const double turned = std::abs(cross(u, d)) + step * (std::abs(u.x * d.y) + std::abs(u.y * d.x));
  const double radicand = u_squared.value * down - bend * (turned * turned) * up;
  if (!(radicand > 0)) return infinity;
  const double along = inner_product(z.metric, u, d).below() * inverse_c;
  const double bound =
      along - 0x1p-20 * std::abs(along) + std::sqrt(radicand) * inverse_root_c * down;
  if (!(bound > 0)) return infinity;
  const double on_edge = root_own / (1 + root_own * inverse_root_c);
  return std::max({std::sqrt(u_squared.value) / bound, on_edge, 0.5 * root_own}) * (up * up);
}

}  // namespace

double quick_reach(const site& v, const site& x, const site& y) {
  const point to_x = between(v, x), to_y = between(v, y);
  if (!(cross(to_x, to_y) > 0)) return infinity;
  const point u = towards_vertex(v, x, y, to_x, to_y);
  const sized_value u_squared = sized_square_norm(v.metric, u), det_v = sized_determinant(v.metric);
  if (!(is_known(u_squared) && is_known(det_v))) return infinity;
  const double beside_x = reach_beside(v, x, to_x, u, u_squared, det_v),
               beside_y = reach_beside(v, y, to_y, u, u_squared, det_v);
  return beside_x > beside_y ? beside_x : beside_y;
}

}  // namespace asterism::internal::audit_detail
