// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/point_in_domain.hpp"

#include <algorithm>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

enum class on_ray { nothing, crossed, through_origin };

// Returns how the segment a b meets the ray from q towards greater x, which is moved up by an
// infinitesimal, so that it misses every vertex.
on_ray meets_ray(const point& q, const point& a, const point& b) {
  const bool between_y = std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
  if (!between_y || std::max(a.x, b.x) < q.x) return on_ray::nothing;
  const bool spans = (a.y <= q.y) != (b.y <= q.y);
  if (std::min(a.x, b.x) > q.x) return spans ? on_ray::crossed : on_ray::nothing;
  const sign side = filtered_kernel().orientation(a, b, q);
  if (side == sign::zero) return on_ray::through_origin;
  return spans && (side == sign::positive) == (a.y < b.y) ? on_ray::crossed : on_ray::nothing;
}

}  // namespace

bool contains(const domain& d, const point& q) {
  bool inside = false;
  for (const segment& s : d.segments) {
    const on_ray how = meets_ray(q, d.vertices[s.a], d.vertices[s.b]);
    if (how == on_ray::through_origin) return false;
    inside ^= how == on_ray::crossed && !s.internal;
  }
  return inside;
}

inside_index::inside_index(const domain& d, std::optional<int> region)
    : box_(d.box()), segments_(box_) {
  const auto bounds = [&](const segment& s) {
    if (!region) return !s.internal;
    const bool on_left = s.left_region == *region;
    return s.internal ? on_left != (s.right_region == *region) : on_left;
  };
  for (const segment& s : d.segments) {
    if (!bounds(s)) continue;
    const ends one{d.vertices[s.a], d.vertices[s.b]};
    segments_.insert(static_cast<std::uint32_t>(ends_.size()), box_of(one.a, one.b));
    ends_.push_back(one);
  }
}

bool inside_index::contains(const point& q) const {
  bool inside = false, on_border = false;
  const bounding_box ray{q, {std::max(q.x, box_.high.x), q.y}};
  segments_.visit(ray, [&](std::uint32_t i) {
    const on_ray how = meets_ray(q, ends_[i].a, ends_[i].b);
    inside ^= how == on_ray::crossed;
    on_border = how == on_ray::through_origin;
    return !on_border;
  });
  return inside && !on_border;
}

}  // namespace asterism::internal
