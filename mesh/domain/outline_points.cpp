// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/outline_points.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

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
  // Counter-clockwise: b, v, a would be the ring's direction turned round.
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

}  // namespace

bool add_hole_points(domain& shape) {
  std::vector<vertex_index> next(shape.vertices.size(), none);
  for (const segment& s : shape.segments) {
    if (s.internal) continue;
    if (next[s.a] != none) return false;
    next[s.a] = s.b;
  }
  std::vector<char> seen(next.size(), 0);
  for (vertex_index start = 0; start < next.size(); ++start) {
    if (next[start] == none || seen[start] != 0) continue;
    std::vector<vertex_index> ring;
    for (vertex_index v = start; v != none && seen[v] == 0; v = next[v]) {
      seen[v] = 1;
      ring.push_back(v);
    }
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

double area_of(const mesh& m) {
  double sum = 0;
  for (const triangle& t : m.triangles)
    sum += doubled(m.sites[t[0]].position, m.sites[t[1]].position, m.sites[t[2]].position) / 2;
  return sum;
}

double enclosed_area(const domain& d) {
  double sum = 0;
  if (d.vertices.empty()) return 0;
  const point& from = d.vertices[0];
  for (const segment& s : d.segments)
    if (!s.internal) sum += doubled(from, d.vertices[s.a], d.vertices[s.b]) / 2;
  return sum;
}

}  // namespace asterism::internal
