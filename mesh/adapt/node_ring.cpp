// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/node_ring.hpp"

#include <cmath>
#include <numbers>

#include "asterism/mesh/adapt/shape_energy.hpp"
#include "asterism/mesh/support/infinity.hpp"

namespace asterism::internal::adapting {

bool node_ring::gather(const editable_mesh& m, vertex_index v, const face_list& at) {
  if (at.size() > most_faces) return false;
  faces_ = at.size();
  padded_ = faces_ + faces_ % 2;
  const auto put = [&](std::size_t k, vertex_index u) {
    const node& n = m.at(u);
    x_[k] = n.position.x;
    y_[k] = n.position.y;
    root_[k] = n.root;
    m11_[k] = n.metric.m11;
    m12_[k] = n.metric.m12;
    m22_[k] = n.metric.m22;
    const double scale = scale_of_shape / n.root;
    n11_[k] = n.metric.m11 * scale;
    n12_[k] = 2 * n.metric.m12 * scale;
    n22_[k] = n.metric.m22 * scale;
  };
  for (std::size_t k = 0; k < faces_; ++k) {
    const face& f = m.faces()[at[k]];
    put(k, f.v[after(f.corner_of(v))]);
  }
  const face& last = m.faces()[at.back()];
  const vertex_index end = last.v[before(last.corner_of(v))];
  for (std::size_t k = faces_; k <= padded_; ++k) put(k, end);
  return true;
}

void node_ring::measure(const node& v, double unit, energies& out) const {
  const double x = v.position.x, y = v.position.y, root = v.root;
  const double scale = scale_of_shape / root;
  const double n11 = v.metric.m11 * scale, n12 = 2 * v.metric.m12 * scale,
               n22 = v.metric.m22 * scale;
  const double size_factor = unit > 0 ? 1 / (unit_size * unit * unit) : 0;
  values left, right, shape, size;
  for (std::size_t k = 0; k < padded_; ++k) {
    const double ux = x_[k] - x, uy = y_[k] - y, wx = x_[k + 1] - x, wy = y_[k + 1] - y;
    const double vx = wx - ux, vy = wy - uy;
    left[k] = ux * wy;
    right[k] = uy * wx;
    const double twice = left[k] - right[k], inverse = 1 / twice;
    // Sums of the products of the sides' coordinates.
    const double xx = ux * ux + wx * wx + vx * vx, xy = ux * uy + wx * wy + vx * vy,
                 yy = uy * uy + wy * wy + vy * vy;
    const double p = (n11 * xx + n12 * xy + n22 * yy) * inverse,
                 q = (n11_[k] * xx + n12_[k] * xy + n22_[k] * yy) * inverse,
                 r = (n11_[k + 1] * xx + n12_[k + 1] * xy + n22_[k + 1] * yy) * inverse;
    const double low_p = twice_above_poor(p), low_q = twice_above_poor(q),
                 low_r = twice_above_poor(r);
    shape[k] = (p + q + r + weight_of_low / 4 * (low_p * low_p + low_q * low_q + low_r * low_r)) *
               (1.0 / 3);
    const double s = twice * (root + root_[k] + root_[k + 1]) * size_factor;
    size[k] = weight_of_size * (s + 1 / s - 2);
  }
  out.sum = 0;
  for (std::size_t k = 0; k < faces_; ++k) {
    out.shape[k] = turns_left(left[k], right[k]) ? shape[k] : infinity;
    out.whole[k] = unit > 0 ? out.shape[k] + size[k] : out.shape[k];
    out.sum += out.whole[k];
  }
}

point node_ring::best_place(double unit, const energies& now) const {
  double x = 0, y = 0, weights = 0;
  for (std::size_t k = 0; k < faces_; ++k) {
    const metric_tensor m{m11_[k] + m11_[k + 1], m12_[k] + m12_[k + 1], m22_[k] + m22_[k + 1]};
    const double root = plain_root_of_determinant(m);
    const double ex = x_[k + 1] - x_[k], ey = y_[k + 1] - y_[k];
    const double length = std::sqrt(squared(m, ex, ey) / 2);
    if (!(root > 0 && length > 0)) continue;
    // Rotates by a quarter turn in the metric, sqrt(det m) m^-1 J, scaled to the mean of two
    // heights: of a unit triangle and of the equilateral one on this edge.
    const double height = std::numbers::sqrt3 / 4 * (unit > 0 ? 1 + unit / length : 2);
    const double tx = (-m.m22 * ey - m.m12 * ex) / root, ty = (m.m12 * ey + m.m11 * ex) / root;
    const double w = now.whole[k];
    x += w * (x_[k] + ex / 2 + height * tx);
    y += w * (y_[k] + ey / 2 + height * ty);
    weights += w;
  }
  return {x / weights, y / weights};
}

}  // namespace asterism::internal::adapting
