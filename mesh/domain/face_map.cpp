// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/face_map.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "asterism/core/sign.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/support/joined_sets.hpp"

namespace asterism::internal {

namespace {

std::size_t twin(std::size_t half_edge) { return half_edge ^ 1; }

}  // namespace

face_map::face_map(const std::vector<point>& vertices, const std::vector<covered_edge>& edges)
    : vertices_(vertices), edges_(edges) {
  sort_around_vertices();
  walk_faces();
  join_walks();
}

vertex_index face_map::origin(std::size_t half_edge) const {
  const covered_edge& e = edges_[half_edge / 2];
  return half_edge % 2 == 0 ? e.a : e.b;
}

// Sorts the directions at each vertex counter-clockwise, beginning after straight down: first those
// to the right or straight up, in which the other end is lexicographically greater.
void face_map::sort_around_vertices() {
  const filtered_kernel kernel;
  around_.resize(vertices_.size());
  position_.resize(2 * edges_.size());
  for (std::size_t h = 0; h < 2 * edges_.size(); ++h) around_[origin(h)].push_back(h);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const point& p = vertices_[v];
    std::sort(around_[v].begin(), around_[v].end(), [&](std::size_t g, std::size_t h) {
      const point &a = vertices_[origin(twin(g))], &b = vertices_[origin(twin(h))];
      const bool a_right = lexicographically_less(p, a), b_right = lexicographically_less(p, b);
      if (a_right != b_right) return a_right;
      return kernel.orientation(p, a, b) == sign::positive;
    });
    for (std::size_t i = 0; i < around_[v].size(); ++i) position_[around_[v][i]] = i;
  }
}

// Numbers the walks from 1; 0 is the number of the outside.
void face_map::walk_faces() {
  constexpr std::size_t none = 0;
  face_of_.assign(2 * edges_.size(), none);
  std::size_t walks = 0;
  for (std::size_t start = 0; start < face_of_.size(); ++start) {
    if (face_of_[start] != none) continue;
    ++walks;
    // Continues with the leftmost turn at the end of h: the half-edge clockwise from its reverse.
    for (std::size_t h = start; face_of_[h] == none;) {
      face_of_[h] = walks;
      const auto& out = around_[origin(twin(h))];
      const std::size_t back = position_[twin(h)];
      h = out[(back + out.size() - 1) % out.size()];
    }
  }
}

void face_map::join_walks() {
  joined_sets parts(vertices_.size());
  for (const covered_edge& e : edges_) parts.join(e.a, e.b);
  std::vector<std::size_t> lowest(vertices_.size(), vertices_.size());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    std::size_t& low = lowest[parts.find(v)];
    const bool lower =
        low == vertices_.size() || lexicographically_less(vertices_[v], vertices_[low]);
    if (!around_[v].empty() && lower) low = v;
  }
  std::size_t walks = 0;
  for (const std::size_t walk : face_of_) walks = std::max(walks, walk);
  joined_sets faces(walks + 1);
  std::erase(lowest, vertices_.size());
  std::vector<point> places;
  for (const std::size_t v : lowest) places.push_back(vertices_[v]);
  const std::vector<std::size_t> below = half_edges_below(places);
  for (std::size_t i = 0; i < lowest.size(); ++i) {
    // Takes the wedge past the last edge: all edges at v leave to the right or straight up, so that
    // wedge is outside.
    const std::size_t outer_walk = face_of_[around_[lowest[i]].back()];
    faces.join(outer_walk, below[i] == no_half_edge ? outside : face_of_[below[i]]);
  }
  for (std::size_t& face : face_of_) face = faces.find(face);
}

// Orders half-edges that run to the right and have a common x by height there. A point comes after
// the half-edges that pass below it.
struct face_map::by_height {
  using is_transparent = void;
  const face_map& map;

  bool operator()(std::size_t g, std::size_t h) const { return map.is_above(h, g); }
  bool operator()(std::size_t g, const point& q) const {
    return filtered_kernel().orientation(map.vertices_[map.origin(g)],
                                         map.vertices_[map.origin(twin(g))], q) == sign::positive;
  }
};

// Sweeps over the plane from the left. A ray runs down from each point, moved to the left by an
// infinitesimal: it meets no vertex, and an edge that begins at the point's x is not met. So a ray
// can meet an edge that begins at a smaller x and ends at the point's x or a greater one.
std::vector<std::size_t> face_map::half_edges_below(const std::vector<point>& points) const {
  const auto left = [&](std::size_t h) { return vertices_[origin(h)].x; };
  const auto right = [&](std::size_t h) { return vertices_[origin(twin(h))].x; };
  std::vector<std::size_t> begins;
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (left(2 * e) != right(2 * e))
      begins.push_back(left(2 * e) < right(2 * e) ? 2 * e : 2 * e + 1);
  std::vector<std::size_t> ends = begins, order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto sort_by = [](std::vector<std::size_t>& all, const auto& x) {
    std::sort(all.begin(), all.end(), [&](std::size_t i, std::size_t j) { return x(i) < x(j); });
  };
  sort_by(begins, left);
  sort_by(ends, right);
  sort_by(order, [&](std::size_t i) { return points[i].x; });
  std::set<std::size_t, by_height> passed(by_height{*this});
  std::vector<std::size_t> below(points.size(), no_half_edge);
  auto first = begins.begin(), last = ends.begin();
  for (const std::size_t i : order) {
    const point& q = points[i];
    for (; first != begins.end() && left(*first) < q.x; ++first) {
      for (; last != ends.end() && right(*last) <= left(*first); ++last) passed.erase(*last);
      passed.insert(*first);
    }
    for (; last != ends.end() && right(*last) < q.x; ++last) passed.erase(*last);
    const auto above = passed.lower_bound(q);
    if (above != passed.begin()) below[i] = *std::prev(above);
  }
  return below;
}

// True if g is above h. Both run to the right, do not cross, and have an interval of x in common.
bool face_map::is_above(std::size_t g, std::size_t h) const {
  const filtered_kernel kernel;
  const point &a = vertices_[origin(g)], &b = vertices_[origin(twin(g))];
  const point &c = vertices_[origin(h)], &d = vertices_[origin(twin(h))];
  sign above = a.x >= c.x ? kernel.orientation(c, d, a) : -kernel.orientation(a, b, c);
  // Compares the right ends where the left ends coincide, or one edge starts on the other one.
  if (above == sign::zero)
    above = b.x <= d.x ? kernel.orientation(c, d, b) : -kernel.orientation(a, b, d);
  return above == sign::positive;
}

std::vector<std::size_t> face_map::faces_around(const std::vector<point>& points) const {
  std::vector<std::size_t> faces = half_edges_below(points);
  for (std::size_t& f : faces) f = f == no_half_edge ? outside : face_of_[f];
  return faces;
}

std::size_t face_map::edge_through(const point& q) const {
  const filtered_kernel kernel;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const point &a = vertices_[edges_[e].a], &b = vertices_[edges_[e].b];
    const bool in_box = std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) &&
                        std::min(a.y, b.y) <= q.y && q.y <= std::max(a.y, b.y);
    if (in_box && kernel.orientation(a, b, q) == sign::zero) return e;
  }
  return edges_.size();
}

}  // namespace asterism::internal
