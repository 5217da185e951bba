// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/visibility.hpp"

#include <algorithm>
#include <cstdint>

namespace asterism::internal {
namespace {

bool boxes_apart(const point& p, const point& q, const point& r, const point& s) {
  return std::max(p.x, q.x) < std::min(r.x, s.x) || std::max(r.x, s.x) < std::min(p.x, q.x) ||
         std::max(p.y, q.y) < std::min(r.y, s.y) || std::max(r.y, s.y) < std::min(p.y, q.y);
}

}  // namespace

bool strictly_between(const point& p, const point& q, const point& r) {
  return (lexicographically_less(p, q) && lexicographically_less(q, r)) ||
         (lexicographically_less(r, q) && lexicographically_less(q, p));
}

bool on_open_segment(const star_predicates& kernel, const point& p, const point& q,
                     const point& at) {
  return strictly_between(p, at, q) && kernel.orientation(p, q, at) == sign::zero;
}

bool properly_cross(const star_predicates& kernel, const point& p, const point& q, const point& r,
                    const point& s) {
  if (boxes_apart(p, q, r, s)) return false;
  const sign side_r = kernel.orientation(p, q, r), side_s = kernel.orientation(p, q, s);
  if (side_r * side_s != sign::negative) return false;
  return kernel.orientation(r, s, p) * kernel.orientation(r, s, q) == sign::negative;
}

bool sees(const boundary& b, const std::vector<site>& sites, const star_predicates& kernel,
          vertex_index v, vertex_index w, const proximity* near) {
  const point &p = sites[v].position, &q = sites[w].position;
  std::uint64_t looked_at = 0;
  const auto lets_through = [&](const boundary_edge& subsegment) {
    ++looked_at;
    const point &r = sites[subsegment.a].position, &s = sites[subsegment.b].position;
    if (boxes_apart(p, q, r, s)) return true;
    // Tests the starts alone: every boundary vertex is the start of a subsegment.
    if (subsegment.a != v && subsegment.a != w && on_open_segment(kernel, p, q, r)) return false;
    const bool shares_end =
        subsegment.a == v || subsegment.a == w || subsegment.b == v || subsegment.b == w;
    return shares_end || !properly_cross(kernel, p, q, r, s);
  };
  const bool seen = near == nullptr
                        ? std::all_of(b.subsegments().begin(), b.subsegments().end(), lets_through)
                        : near->subsegments().visit(box_of(p, q), [&](std::uint32_t i) {
                            return lets_through(b.subsegments()[i]);
                          });
  kernel.counters().looked_at += looked_at;
  return seen;
}

}  // namespace asterism::internal
