// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/shape_energy.hpp"

#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::adapting {

double shape_energy(const node& a, const node& b, const node& c, double unit) {
  if (!turns_left(a.position, b.position, c.position)) return infinity;
  const double ux = b.position.x - a.position.x, uy = b.position.y - a.position.y;
  const double wx = c.position.x - a.position.x, wy = c.position.y - a.position.y;
  const double vx = wx - ux, vy = wy - uy;
  const double twice = ux * wy - uy * wx;
  // Returns the sum of the squared lengths of the three sides in a metric.
  const double xx = ux * ux + wx * wx + vx * vx, xy = ux * uy + wx * wy + vx * vy,
               yy = uy * uy + wy * wy + vy * vy;
  double shape = 0;
  for (const node* n : {&a, &b, &c}) {
    const metric_tensor& m = n->metric;
    const double q =
        (m.m11 * xx + 2 * m.m12 * xy + m.m22 * yy) / (2 * std::numbers::sqrt3 * twice * n->root);
    const double low = twice_above_poor(q);
    shape += q + weight_of_low / 4 * (low * low);
  }
  return unit <= 0 ? shape / 3 : shape / 3 + size_energy(a, b, c, unit);
}

double size_energy(const node& a, const node& b, const node& c, double unit) {
  const double twice = (b.position.x - a.position.x) * (c.position.y - a.position.y) -
                       (b.position.y - a.position.y) * (c.position.x - a.position.x);
  const double size = twice * (a.root + b.root + c.root) / (unit_size * unit * unit);
  return weight_of_size * (size + 1 / size - 2);
}

}  // namespace asterism::internal::adapting
