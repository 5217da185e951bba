// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/star_outline.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/covectors.hpp"

namespace asterism::internal::audit_detail {
namespace {

// The covector g = M h, where M is the metric of the site w at `to`, so that |g|_w^2 is g . h. The
// computed g has an error of at most `roundings::step` times its magnitudes; h need not be exact.
class dividing_covector {
 public:
  dividing_covector(const point& h, const point& to, const metric_tensor& m)
      : g_{m.m11 * h.x + m.m12 * h.y, m.m12 * h.x + m.m22 * h.y},
        size_{m.m11 * std::abs(h.x) + std::abs(m.m12 * h.y),
              std::abs(m.m12 * h.x) + m.m22 * std::abs(h.y)} {
    constexpr double most = 0x1p200;
    least_ = g_.x * to.x + g_.y * to.y - error(to);
    if (!(least_ > 0x1p-300 && size_.x + size_.y < most && std::abs(to.x) + std::abs(to.y) < most))
      least_ = -1;
    const double squared = g_.x * h.x + g_.y * h.y + error(h) + 0x1p-300;
    length_ = std::sqrt(squared) * (roundings::up * roundings::up);
  }

  bool is_known() const { return least_ > 0; }
  // True if g . w certainly exceeds g . p + |g|_w length(p).
  bool leaves_behind(const outline_point& p) const {
    return g_.x * p.at.x + g_.y * p.at.y + length_ * p.length + error(p.at) < least_;
  }

 private:
  double error(const point& at) const {
    return roundings::step * (size_.x * std::abs(at.x) + size_.y * std::abs(at.y));
  }

  point g_, size_;
  double least_, length_;
};

// Returns the way to w from the point nearest to it, in w's metric, between two points.
point from_nearest(const point& p, const point& q, const point& to, const metric_tensor& m) {
  const point e{q.x - p.x, q.y - p.y}, d{to.x - p.x, to.y - p.y};
  const point dual{m.m11 * e.x + m.m12 * e.y, m.m12 * e.x + m.m22 * e.y};
  const double t = (dual.x * d.x + dual.y * d.y) / (dual.x * e.x + dual.y * e.y);
  const double within = t > 0 ? (t < 1 ? t : 1.0) : 0.0;
  return {d.x - within * e.x, d.y - within * e.y};
}

}  // namespace

// Tries the way from the vertex first, for both halves. If that does not leave the vertex behind, w
// is no farther from the vertex than v is, and no covector does.
bool is_outside_kite(const point& to, const metric_tensor& m, const outline_point& vertex,
                     std::span<const kite_side> sides) {
  const dividing_covector from_vertex({to.x - vertex.at.x, to.y - vertex.at.y}, to, m);
  if (!from_vertex.is_known() || !from_vertex.leaves_behind(vertex)) return false;
  return std::all_of(sides.begin(), sides.end(), [&](const kite_side& side) {
    const auto& [neighbour, on_way] = side;
    const outline_point end{neighbour};
    if (from_vertex.leaves_behind(on_way) && from_vertex.leaves_behind(end)) return true;
    const dividing_covector nearest(from_nearest(on_way.at, vertex.at, to, m), to, m);
    return nearest.is_known() && nearest.leaves_behind(vertex) && nearest.leaves_behind(on_way) &&
           nearest.leaves_behind(end);
  });
}

}  // namespace asterism::internal::audit_detail
