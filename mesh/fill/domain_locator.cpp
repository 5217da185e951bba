// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/domain_locator.hpp"

#include <algorithm>

namespace asterism::internal {

domain_locator::domain_locator(const domain& d) : domain_(&d), box_(d.box()), segments_(box_) {
  for (std::size_t s = 0; s < d.segments.size(); ++s)
    segments_.insert(static_cast<std::uint32_t>(s),
                     box_of(d.vertices[d.segments[s].a], d.vertices[d.segments[s].b]));
}

bool domain_locator::contains(const filtered_kernel& kernel, const point& q) const {
  bool inside = false;
  const auto cross = [&](std::uint32_t i) {
    const segment& s = domain_->segments[i];
    const point &a = domain_->vertices[s.a], &b = domain_->vertices[s.b];
    const bool between_y = std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
    if (!between_y || std::max(a.x, b.x) < q.x) return true;
    // Moves the ray from q towards greater x up by an infinitesimal, so that it misses every
    // vertex.
    const bool spans = !s.internal && (a.y <= q.y) != (b.y <= q.y);
    if (std::min(a.x, b.x) > q.x) {
      inside ^= spans;
      return true;
    }
    const sign side = kernel.orientation(a, b, q);
    if (side == sign::zero) return false;
    inside ^= spans && (side == sign::positive) == (a.y < b.y);
    return true;
  };
  const bounding_box ray{q, {std::max(q.x, box_.high.x), q.y}};
  return segments_.visit(ray, cross) && inside;
}

}  // namespace asterism::internal
