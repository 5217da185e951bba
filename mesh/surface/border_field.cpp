// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface/border_field.hpp"

#include <algorithm>
#include <cmath>

namespace asterism::internal {
namespace {

// Returns x rounded to a multiple of the last of 40 binary digits of `size`.
double rounded_to(double x, double size) {
  constexpr int digits = 40;
  if (!(size > 0) || !std::isfinite(size)) return x;
  const int last = std::ilogb(size) - digits + 1;
  return std::ldexp(std::round(std::ldexp(x, -last)), last);
}

metric_tensor with_few_digits(const metric_tensor& m) {
  const metric_tensor even{rounded_to(m.m11, m.m11), rounded_to(m.m12, std::sqrt(m.m11 * m.m22)),
                           rounded_to(m.m22, m.m22)};
  // Least determinant, relative to its first product, of a rounded tensor that is used: the
  // rounding of the difference does not matter there.
  constexpr double least = 0x1p-30;
  return even.m11 * even.m22 - even.m12 * even.m12 > least * even.m11 * even.m22 ? even : m;
}

}  // namespace

border_field::border_field(const metric_field& of, const domain& d) : of_(&of) {
  for (const segment& s : d.segments) border_.push_back({d.vertices[s.a], d.vertices[s.b]});
}

// Returns the length of the nearest segment plus the growth by the distance from it, in coordinates
// in which the tensor is the identity: x' = l11 x + l21 y, y' = l22 y.
double border_field::wanted_length(const metric_tensor& m, const point& q) const {
  constexpr double growth = 1;  // of the length by the distance
  // Wanted length of edges at a segment, as a multiple of the segment's length: the mesher halves a
  // segment that is 1.2 times as long as wanted at one of its ends, and its neighbours must not be
  // halved for that. With 1.3 the next segment was halved, too, and so on around the border.
  constexpr double room = 2;
  const double l11 = std::sqrt(m.m11), l21 = m.m12 / l11,
               l22 = std::sqrt(std::max(m.m22 - l21 * l21, 0.0));
  double least = 1;
  for (const auto& [a, b] : border_) {
    const double ex = l11 * (b.x - a.x) + l21 * (b.y - a.y), ey = l22 * (b.y - a.y);
    const double px = l11 * (q.x - a.x) + l21 * (q.y - a.y), py = l22 * (q.y - a.y);
    const double squared = ex * ex + ey * ey;
    if (!(room * room * squared < least * least)) continue;
    const double share = squared > 0 ? std::clamp((px * ex + py * ey) / squared, 0.0, 1.0) : 0;
    const double dx = px - share * ex, dy = py - share * ey;
    least = std::min(least, room * std::sqrt(squared) + growth * std::sqrt(dx * dx + dy * dy));
  }
  return least;
}

result<metric_tensor> border_field::at(const point& q) const {
  auto found = of_->at(q);
  if (!found) return found;
  const metric_tensor m = found.value();
  const double length = wanted_length(m, q);
  const double factor = length > 0 ? 1 / (length * length) : 1;
  return with_few_digits({factor * m.m11, factor * m.m12, factor * m.m22});
}

}  // namespace asterism::internal
