// SPDX-License-Identifier: MIT
//
// Decides which segments the ball around a site certainly misses, measured by the site's own
// metric.
//
// Errors. In the frame in which the metric is the identity a displacement d from the site is
//   ( (m11 dx + m12 dy) / sqrt(m11), sqrt(det / m11) dy ).
// The determinant must be more than 2^-20 of its monomials, so it is known to 2^-28 of itself, and
// |m12 dy| / sqrt(m11) is at most 2^11 times the second coordinate: both coordinates are off by
// less than 2^-26 of |p|_1, the sum of their absolute values. So the distance from the site to a
// segment p-q is off by less than 2^-25 (|p|_1 + |q|_1); the few roundings of measuring it in the
// frame are 2^-49 of that sum. `misses` requires 2^-24 of the sum, and adds 2^-20 of the radius for
// the roundings of the comparison itself. In the range of numbers that is checked first, underflow
// takes less.
#pragma once

#include <cmath>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/sized_value.hpp"

namespace asterism::internal::audit_detail {

class metric_ball {
 public:
  explicit metric_ball(const site& centre) : at_(centre.position) {
    const metric_tensor& m = centre.metric;
    const sized_value determinant = sized_determinant(m);
    if (!(determinant.value > 0x1p-20 * determinant.size && m.m11 > 0x1p-300 && m.m22 > 0x1p-300 &&
          m.m11 + m.m22 < 0x1p300))
      return;
    is_usable_ = true;
    along_ = std::sqrt(m.m11);
    across_ = m.m12 / along_;
    up_ = std::sqrt(determinant.value) / along_;
  }

  bool is_usable() const { return is_usable_; }

  // A point in the frame in which the site is the origin and its metric the identity.
  point in_frame(const point& q) const {
    const double dx = q.x - at_.x, dy = q.y - at_.y;
    return {along_ * dx + across_ * dy, up_ * dy};
  }

  // True if no point of the segment between two points of the frame, or within rounding of it, is
  // within this radius of the site. Requires a usable metric.
  static bool misses(const point& p, const point& q, double radius) {
    const double extent = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y);
    const double far = radius * (1 + 0x1p-20) + 0x1p-24 * extent, square = far * far;
    if (!(extent < 0x1p200 && far > 0x1p-200)) return false;
    const point e{q.x - p.x, q.y - p.y};
    if (p.x * e.x + p.y * e.y >= 0) return p.x * p.x + p.y * p.y > square;
    if (q.x * e.x + q.y * e.y <= 0) return q.x * q.x + q.y * q.y > square;
    const double area = p.x * q.y - p.y * q.x;
    return area * area > square * (e.x * e.x + e.y * e.y) + 0x1p-900;
  }

 private:
  point at_;
  double along_ = 0, across_ = 0, up_ = 0;
  bool is_usable_ = false;
};

}  // namespace asterism::internal::audit_detail
