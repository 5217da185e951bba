// SPDX-License-Identifier: MIT
#include "asterism/mesh/transfer/triangle_finder.hpp"

#include <cmath>
#include <numeric>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/numerics/nodal_sums.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"

namespace asterism::internal {

std::size_t triangle_finder::exit_from(vertex_index t, const point& q, std::size_t first) const {
  const auto c = corners(t);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (first + k) % 3;
    if (kernel_.orientation(c[(i + 1) % 3], c[(i + 2) % 3], q) == sign::negative) return i;
  }
  return 3;
}

// Changes the edge that is tested first from step to step: a walk that always prefers one edge may
// cycle.
vertex_index triangle_finder::walk(const point& q, vertex_index t) const {
  const std::size_t most =
      64 + 8 * static_cast<std::size_t>(std::sqrt(static_cast<double>(in_.triangles.size())));
  for (std::size_t step = 0; step < most; ++step) {
    const std::size_t i = exit_from(t, q, step % 3);
    if (i == 3) return t;
    const vertex_index next = links_.across(t, i);
    if (next == no_triangle) return no_triangle;
    t = next;
  }
  return no_triangle;
}

void triangle_finder::make_boxes() {
  if (boxes_) return;
  boxes_.emplace(box_of_sites(in_.sites));
  for (vertex_index t = 0; t < in_.triangles.size(); ++t) {
    const auto c = corners(t);
    bounding_box around = box_of(c[0], c[1]);
    around.include(c[2]);
    boxes_->insert(t, around);
  }
}

std::vector<vertex_index> triangle_finder::find_all(const std::vector<point>& points,
                                                    const bounding_box& box) {
  std::vector<vertex_index> found(points.size(), no_triangle);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  sort_along_curve(order, points, box);
  parallel_chunks(order.size(), nodal_chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    vertex_index last = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const vertex_index t = walk(points[order[i]], last);
      found[order[i]] = t;
      if (t != no_triangle) last = t;
    }
  });
  std::vector<std::uint32_t> rest;
  for (std::uint32_t i = 0; i < found.size(); ++i)
    if (found[i] == no_triangle) rest.push_back(i);
  if (rest.empty()) return found;
  make_boxes();
  for_each_node(rest.size(), [&](std::size_t i) {
    found[rest[i]] = first_with(points[rest[i]], [](vertex_index) { return true; });
  });
  return found;
}

std::vector<vertex_index> locate_points(const mesh& m, const std::vector<point>& points) {
  if (m.triangles.empty() || points.empty())
    return std::vector<vertex_index>(points.size(), no_triangle);
  const mesh_links links(m);
  return triangle_finder(m, links).find_all(points, box_of_sites(m.sites));
}

}  // namespace asterism::internal
