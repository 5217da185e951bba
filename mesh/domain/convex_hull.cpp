// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/convex_hull.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

using ends = std::array<vertex_index, 2>;

ends sorted(vertex_index a, vertex_index b) { return {std::min(a, b), std::max(a, b)}; }

// Returns the vertices from left to right; of vertices at one place only the first.
std::vector<vertex_index> from_left(const domain& d) {
  std::vector<vertex_index> order(d.vertices.size());
  std::iota(order.begin(), order.end(), vertex_index{0});
  std::sort(order.begin(), order.end(), [&d](vertex_index a, vertex_index b) {
    const point &p = d.vertices[a], &q = d.vertices[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
  });
  order.erase(
      std::unique(order.begin(), order.end(),
                  [&d](vertex_index a, vertex_index b) { return d.vertices[a] == d.vertices[b]; }),
      order.end());
  return order;
}

// Returns the lower part of the hull of vertices in their order, with those on its sides.
std::vector<vertex_index> lower_part(const domain& d, const std::vector<vertex_index>& order) {
  const filtered_kernel kernel;
  std::vector<vertex_index> part;
  for (const vertex_index v : order) {
    while (part.size() > 1 &&
           kernel.orientation(d.vertices[part[part.size() - 2]], d.vertices[part.back()],
                              d.vertices[v]) == sign::negative)
      part.pop_back();
    part.push_back(v);
  }
  return part;
}

}  // namespace

result<domain> with_convex_hull(domain d) {
  if (!d.curves.empty())
    return error{d.name + ": curves may reach beyond the convex hull of the vertices",
                 error_code::invalid_domain};
  for (std::size_t v = 0; v < d.vertices.size(); ++v)
    if (!std::isfinite(d.vertices[v].x) || !std::isfinite(d.vertices[v].y))
      return error{fmt::format("{}: vertex {} is not finite", d.name, v + 1),
                   error_code::invalid_domain};
  std::vector<vertex_index> order = from_left(d);
  std::vector<vertex_index> hull = lower_part(d, order);
  if (hull.size() == order.size()) {
    // All vertices are on the lower part of the hull, which has an area unless they are on one
    // line.
    const filtered_kernel kernel;
    const bool flat = std::all_of(hull.begin(), hull.end(), [&](vertex_index v) {
      return kernel.orientation(d.vertices[hull.front()], d.vertices[v], d.vertices[hull.back()]) ==
             sign::zero;
    });
    if (hull.size() < 3 || flat)
      return error{d.name + ": the convex hull has no area: all vertices are on one line",
                   error_code::invalid_domain};
  }
  std::reverse(order.begin(), order.end());
  const std::vector<vertex_index> upper = lower_part(d, order);
  hull.insert(hull.end(), upper.begin() + 1, upper.end());
  std::vector<ends> listed;
  for (const segment& s : d.segments) listed.push_back(sorted(s.a, s.b));
  std::sort(listed.begin(), listed.end());
  std::size_t added = 0;
  for (std::size_t i = 0; i + 1 < hull.size(); ++i) {
    if (std::binary_search(listed.begin(), listed.end(), sorted(hull[i], hull[i + 1]))) continue;
    d.segments.push_back({hull[i], hull[i + 1], 0});
    ++added;
  }
  if (added > 0)
    d.origin.notes.push_back(fmt::format(
        "{} of {} sides of the convex hull are segments of marker 0 now", added, hull.size() - 1));
  return d;
}

}  // namespace asterism::internal
