// SPDX-License-Identifier: MIT
#include "asterism/mesh/optimize/sharp_corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "asterism/core/elementary.hpp"

namespace asterism::internal::fitting {
namespace {

double cross(const point& a, const point& b) { return a.x * b.y - a.y * b.x; }

// Returns the angle from a to b as the site sees them, in degrees.
double angle_seen(const fit_site& from, const point& a, const point& b) {
  const point u = from.seen(a.x - from.position.x, a.y - from.position.y);
  const point w = from.seen(b.x - from.position.x, b.y - from.position.y);
  return elementary::atan2(cross(u, w), u.x * w.x + u.y * w.y) * 180 / std::numbers::pi;
}

}  // namespace

sharp_corners::sharp_corners(const mutable_triangulation& net, double angle_bound) {
  for (vertex_index v = 0; v < net.shape().vertices.size(); ++v)
    for (const vertex_index t : net.around(v)) {
      const std::size_t at = net.triangles()[t].corner_of(v);
      if (net.triangles()[t].segment[(at + 2) % 3] == none) continue;
      if (const auto found = corner_from(net, t, at, angle_bound)) corners_.push_back(*found);
    }
}

// Returns the corner that begins at a subsegment, the triangle's edge from its vertex `at` to the
// next one; none if it is not below the bound.
std::optional<sharp_corners::corner> sharp_corners::corner_from(const mutable_triangulation& net,
                                                                vertex_index t, std::size_t at,
                                                                double angle_bound) {
  const vertex_index v = net.triangles()[t].v[at];
  const fit_site& centre = net.sites()[v];
  const point& o = centre.position;
  const point first = net.sites()[net.triangles()[t].v[(at + 1) % 3]].position;
  double angle = 0;
  for (std::size_t turns = 0; turns < net.around(v).size(); ++turns) {
    const fit_triangle& here = net.triangles()[t];
    const std::size_t i = here.corner_of(v);
    const point& last = net.sites()[here.v[(i + 2) % 3]].position;
    angle += angle_seen(centre, net.sites()[here.v[(i + 1) % 3]].position, last);
    if (!(angle < angle_bound)) return std::nullopt;
    if (here.segment[(i + 1) % 3] != none)
      return corner{v, {first.x - o.x, first.y - o.y}, {last.x - o.x, last.y - o.y}};
    t = here.next[(i + 1) % 3];
  }
  return std::nullopt;
}

// Compares directions with the middle of a triangle's corner. Edges do not cross segments, so that
// middle tells on which side of them the triangle is.
bool sharp_corners::touch(const mutable_triangulation& net,
                          const std::array<vertex_index, 3>& v) const {
  if (corners_.empty()) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (net.kind(v[i]) != vertex_kind::given) continue;
    const auto [first, last] =
        std::equal_range(corners_.begin(), corners_.end(), corner{v[i], {}, {}},
                         [](const corner& a, const corner& b) { return a.vertex < b.vertex; });
    const point &o = net.sites()[v[i]].position, &p = net.sites()[v[(i + 1) % 3]].position,
                &q = net.sites()[v[(i + 2) % 3]].position;
    const point middle{(p.x - o.x) + (q.x - o.x), (p.y - o.y) + (q.y - o.y)};
    if (std::any_of(first, last, [&](const corner& c) {
          return cross(c.first, middle) > 0 && cross(middle, c.last) > 0;
        }))
      return true;
  }
  return false;
}

}  // namespace asterism::internal::fitting
