// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/point_in_domain.hpp"

#include <algorithm>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {

bool contains(const domain& d, const point& q) {
  const filtered_kernel kernel;
  bool inside = false;
  for (const segment& s : d.segments) {
    const point& a = d.vertices[s.a];
    const point& b = d.vertices[s.b];
    const bool between_y = std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
    if (!between_y || std::max(a.x, b.x) < q.x) continue;
    // The ray from q towards greater x, moved up by an infinitesimal: it misses every vertex.
    const bool spans = !s.internal && (a.y <= q.y) != (b.y <= q.y);
    if (std::min(a.x, b.x) > q.x) {
      inside ^= spans;
      continue;
    }
    const sign side = kernel.orientation(a, b, q);
    if (side == sign::zero) return false;
    inside ^= spans && (side == sign::positive) == (a.y < b.y);
  }
  return inside;
}

}  // namespace asterism::internal
