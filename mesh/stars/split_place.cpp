// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/split_place.hpp"

#include "asterism/mesh/stars/visibility.hpp"

namespace asterism::internal {
namespace {

bool in_closed_triangle(const star_predicates& kernel, const point& a, const point& b,
                        const point& c, const point& q) {
  return kernel.orientation(a, b, q) != sign::negative &&
         kernel.orientation(b, c, q) != sign::negative &&
         kernel.orientation(c, a, q) != sign::negative;
}

bool is_in(const bounding_box& box, const point& q) {
  return box.low.x <= q.x && q.x <= box.high.x && box.low.y <= q.y && q.y <= box.high.y;
}

}  // namespace

bool leaves_others_in_place(const star_predicates& kernel, const std::vector<site>& sites,
                            const boundary& edges, const proximity& near,
                            const boundary_edge& subsegment, const point& m, bool on_curve) {
  const point &a = sites[subsegment.a].position, &b = sites[subsegment.b].position;
  bounding_box box = box_of(a, b);
  if (on_curve) box.include(m);
  if (!is_in(box, m) || m == a || m == b) return false;
  const sign turn = kernel.orientation(a, b, m);
  if (turn == sign::zero) return true;  // on the segment, which is already part of the boundary
  const bool left = turn == sign::positive;
  const bool no_site = near.sites().visit_box(sites, box.low, box.high, [&](vertex_index w) {
    return w == subsegment.a || w == subsegment.b ||
           !in_closed_triangle(kernel, a, left ? b : m, left ? m : b, sites[w].position);
  });
  return no_site && near.subsegments().visit(box, [&](std::uint32_t i) {
    const boundary_edge& p = edges.subsegments()[i];
    const point &r = sites[p.a].position, &s = sites[p.b].position;
    return !on_open_segment(kernel, r, s, m) && !properly_cross(kernel, a, m, r, s) &&
           !properly_cross(kernel, m, b, r, s);
  });
}

}  // namespace asterism::internal
