// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/strictly_inside.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace asterism::internal {

// Counts crossings of a ray to the right, or upwards where the sites' box is wider than it is high:
// a ray along a flat domain would meet half of its subsegments.
bool strictly_inside(const boundary& b, const std::vector<site>& sites,
                     const star_predicates& kernel, const point& q, const proximity* near) {
  const bool upwards = near != nullptr && near->box().high.x - near->box().low.x >
                                              near->box().high.y - near->box().low.y;
  const auto along = [&](const point& p) { return upwards ? p.y : p.x; };
  const auto across = [&](const point& p) { return upwards ? p.x : p.y; };
  const sign turned = upwards ? sign::negative : sign::positive;  // x and y change places
  bool inside = false;  // an internal subsegment is crossed twice
  std::uint64_t looked_at = 0;
  const auto pass = [&](const boundary_edge& subsegment) {
    ++looked_at;
    const point &p = sites[subsegment.a].position, &r = sites[subsegment.b].position;
    if (std::max(across(p), across(r)) < across(q) || std::min(across(p), across(r)) > across(q))
      return true;
    if (std::max(along(p), along(r)) < along(q)) return true;
    const sign side = kernel.orientation(p, r, q) * turned;
    const bool is_beside = std::min(along(p), along(r)) <= along(q);
    if (side == sign::zero && is_beside) return false;  // the range across was checked above
    // Counts a subsegment for half-open ranges of the height, so that a ray through a vertex
    // crosses there once.
    const bool forth = across(p) <= across(q) && across(q) < across(r),
               back = across(r) <= across(q) && across(q) < across(p);
    if ((forth && side == sign::positive) || (back && side == sign::negative)) inside = !inside;
    return true;
  };
  constexpr double far = std::numeric_limits<double>::max();
  const bounding_box ray{q, upwards ? point{q.x, far} : point{far, q.y}};
  const bool is_clear = near == nullptr
                            ? std::all_of(b.subsegments().begin(), b.subsegments().end(), pass)
                            : near->subsegments().visit(
                                  ray, [&](std::uint32_t i) { return pass(b.subsegments()[i]); });
  kernel.counters().looked_at += looked_at;
  return is_clear && inside;
}

}  // namespace asterism::internal
