// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_outline.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/covectors.hpp"

namespace asterism::internal::audit_detail {
// With g = M h, M the metric, |g|_w^2 is g . h. The computed g has an error of at most
// `roundings::step` times its magnitudes; h need not be exact.
bool is_outside_kite(const point& to, const metric_tensor& m, const outline_point& vertex,
                     std::span<const outline_point> others) {
  const point h{to.x - vertex.at.x, to.y - vertex.at.y};
  const point g{m.m11 * h.x + m.m12 * h.y, m.m12 * h.x + m.m22 * h.y};
  const point size{m.m11 * std::abs(h.x) + std::abs(m.m12 * h.y),
                   std::abs(m.m12 * h.x) + m.m22 * std::abs(h.y)};
  const auto error = [&size](const point& at) {
    return roundings::step * (size.x * std::abs(at.x) + size.y * std::abs(at.y));
  };
  constexpr double most = 0x1p200;
  const double least = g.x * to.x + g.y * to.y - error(to);
  const bool in_range =
      least > 0x1p-300 && size.x + size.y < most && std::abs(to.x) + std::abs(to.y) < most;
  if (!in_range) return false;
  const double squared = g.x * h.x + g.y * h.y + error(h) + 0x1p-300;
  const double length = std::sqrt(squared) * (roundings::up * roundings::up);
  const auto is_below = [&](const outline_point& p) {
    return g.x * p.at.x + g.y * p.at.y + length * p.length + error(p.at) < least;
  };
  return is_below(vertex) && std::all_of(others.begin(), others.end(), is_below);
}

}  // namespace asterism::internal::audit_detail
