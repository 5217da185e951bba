// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/outline_points.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/data/region_of.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {
namespace {

constexpr vertex_index none = std::numeric_limits<vertex_index>::max();

double doubled(const point& a, const point& b, const point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Returns a point inside the ring: between its lowest vertex and the vertex of the domain that is
// deepest in the triangle there, or in the middle of that triangle. `ring` turns clockwise.
point point_inside(const domain& d, const std::vector<vertex_index>& ring) {
  const auto at = std::min_element(ring.begin(), ring.end(), [&](vertex_index p, vertex_index q) {
    return lexicographically_less(d.vertices[p], d.vertices[q]);
  });
  const std::size_t i = static_cast<std::size_t>(at - ring.begin()), n = ring.size();
  const point &v = d.vertices[ring[i]], &a = d.vertices[ring[(i + 1) % n]],
              &b = d.vertices[ring[(i + n - 1) % n]];
  // Takes the orientation of b, v, a, which is that of the reversed ring: counter-clockwise.
  const double whole = doubled(v, b, a) > 0 ? 1 : -1;
  double deepest = 0;
  const point* found = nullptr;
  for (const point& q : d.vertices) {
    if (q == v || q == a || q == b) continue;
    const double in_a = whole * doubled(v, b, q), in_b = whole * doubled(v, q, a),
                 from_ab = whole * doubled(b, a, q);
    if (in_a < 0 || in_b < 0 || from_ab < 0 || !(from_ab > deepest)) continue;
    deepest = from_ab;
    found = &q;
  }
  if (found != nullptr) return {v.x / 2 + found->x / 2, v.y / 2 + found->y / 2};
  return {(v.x + a.x + b.x) / 3, (v.y + a.y + b.y) / 3};
}

// Walks along the boundary with the outside of the mesh on the right. Where rings touch, several
// segments begin at a vertex; the walk goes on along the first one counter-clockwise from where it
// came, beyond which the mesh begins again. So each walk is around one hole, or around the whole.
class ring_walk {
 public:
  explicit ring_walk(const domain& shape) : shape_(shape), from_(shape.vertices.size()) {
    for (vertex_index s = 0; s < shape.segments.size(); ++s)
      if (!shape.segments[s].internal) from_[shape.segments[s].a].push_back(s);
  }

  // Returns the segment after this one; none where the boundary ends.
  vertex_index next(vertex_index s) const {
    const segment& came = shape_.segments[s];
    vertex_index first = none;
    for (const vertex_index t : from_[came.b])
      if (first == none || is_before(came, t, first)) first = t;
    return first;
  }

 private:
  // Classifies the counter-clockwise angle at b from a to q: 0 for less than half a turn, 1 for
  // half a turn, 2 for more, 3 for a full turn.
  int part_of_turn(const point& b, const point& a, const point& q) const {
    const sign side = kernel_.orientation(b, a, q);
    if (side == sign::positive) return 0;
    if (side == sign::negative) return 2;
    return lexicographically_less(b, a) == lexicographically_less(b, q) ? 3 : 1;
  }

  bool is_before(const segment& came, vertex_index s, vertex_index t) const {
    const point &a = shape_.vertices[came.a], &b = shape_.vertices[came.b],
                &p = shape_.vertices[shape_.segments[s].b],
                &q = shape_.vertices[shape_.segments[t].b];
    const int to_p = part_of_turn(b, a, p), to_q = part_of_turn(b, a, q);
    if (to_p != to_q) return to_p < to_q;
    return kernel_.orientation(b, p, q) == sign::positive;
  }

  const domain& shape_;
  std::vector<std::vector<vertex_index>> from_;  // segments that begin at each vertex
  filtered_kernel kernel_;
};

}  // namespace

bool add_hole_points(domain& shape) {
  const ring_walk walk(shape);
  std::vector<char> seen(shape.segments.size(), 0);
  for (vertex_index start = 0; start < seen.size(); ++start) {
    if (shape.segments[start].internal || seen[start] != 0) continue;
    std::vector<vertex_index> ring;
    vertex_index s = start;
    for (; s != none && seen[s] == 0; s = walk.next(s)) {
      seen[s] = 1;
      ring.push_back(shape.segments[s].a);
    }
    if (s != start) return false;
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      area += doubled(shape.vertices[ring[0]], shape.vertices[ring[i]],
                      shape.vertices[ring[(i + 1) % ring.size()]]);
    if (area < 0) shape.holes.push_back(point_inside(shape, ring));
  }
  return true;
}

void add_region_points(const mesh& m, domain& shape) {
  if (m.regions.empty()) return;
  const mesh_links links(m);
  std::vector<std::array<vertex_index, 2>> walls;
  for (const boundary_edge& e : m.boundary)
    walls.push_back({std::min(e.a, e.b), std::max(e.a, e.b)});
  std::sort(walls.begin(), walls.end());
  std::vector<char> seen(m.triangles.size(), 0);
  for (vertex_index start = 0; start < seen.size(); ++start) {
    if (seen[start] != 0) continue;
    std::vector<vertex_index> open{start};
    seen[start] = 1;
    double largest = 0;
    point middle{};
    while (!open.empty()) {
      const vertex_index t = open.back();
      open.pop_back();
      const triangle& c = m.triangles[t];
      const point &p = m.sites[c[0]].position, &q = m.sites[c[1]].position,
                  &r = m.sites[c[2]].position;
      if (const double area = doubled(p, q, r); area > largest) {
        largest = area;
        middle = {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index a = c[(i + 1) % 3], b = c[(i + 2) % 3], n = links.across(t, i);
        if (n == no_triangle || seen[n] != 0 ||
            std::binary_search(walls.begin(), walls.end(),
                               std::array{std::min(a, b), std::max(a, b)}))
          continue;
        seen[n] = 1;
        open.push_back(n);
      }
    }
    shape.regions.push_back({middle, m.regions[start], 0});
  }
}

region_sizes sizes_of_regions(const mesh& m) {
  region_sizes sizes;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const triangle& t = m.triangles[i];
    sizes[region_of(m, i)] +=
        doubled(m.sites[t[0]].position, m.sites[t[1]].position, m.sites[t[2]].position) / 2;
  }
  return sizes;
}

region_sizes enclosed_sizes(const domain& d) {
  region_sizes sizes;
  if (d.vertices.empty()) return sizes;
  const point& from = d.vertices[0];
  for (const segment& s : d.segments) {
    const double part = doubled(from, d.vertices[s.a], d.vertices[s.b]) / 2;
    sizes[s.left_region] += part;
    if (s.internal) sizes[s.right_region] -= part;
  }
  return sizes;
}

}  // namespace asterism::internal
