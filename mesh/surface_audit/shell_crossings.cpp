// SPDX-License-Identifier: MIT
//
// Uses that two triangles have a point in common, other than in common vertices and edges, if and
// only if an edge of one meets the other there: their intersection is convex, and its extreme
// points are on edges. With a common vertex it is enough to test the edges opposite to it, as the
// intersection is a star about that vertex. With a common edge a further point makes them lie in
// one plane, on one side of the edge.
#include "asterism/mesh/surface_audit/shell_crossings.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/support/parallel_for.hpp"
#include "asterism/mesh/surface_audit/deviation_scene.hpp"

namespace asterism::internal {
namespace {

using corners = std::array<space_point, 3>;

template <class Number>
Number volume(const space_point& a, const space_point& b, const space_point& c,
              const space_point& d) {
  const auto at = vector_of<Number>(a);
  return dot(cross(vector_of<Number>(b) - at, vector_of<Number>(c) - at),
             vector_of<Number>(d) - at);
}

int sign_of_exact(const dyadic& x) {
  if (x.is_zero()) return 0;
  return x.sign_value() == sign::positive ? 1 : -1;
}

[[gnu::noinline]] rounded_interval enclosed_volume(const space_point& a, const space_point& b,
                                                   const space_point& c, const space_point& d) {
  return volume<rounded_interval>(a, b, c, d);
}

// Returns the side of the plane of a, b, c that d is on: 1, -1, or 0 on it.
int side(const space_point& a, const space_point& b, const space_point& c, const space_point& d) {
  {
    const floating_point_scope scope(rounding::upward);
    const rounded_interval v = enclosed_volume(a, b, c, d);
    if (v.inf() > 0) return 1;
    if (v.sup() < 0) return -1;
  }
  return sign_of_exact(volume<dyadic>(a, b, c, d));
}

double coordinate(const space_point& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

// Returns the orientation of three points in the plane of two coordinates.
int turn(const space_point& a, const space_point& b, const space_point& c, int i, int k) {
  const auto difference = [](double x, double y) { return dyadic(x) - dyadic(y); };
  return sign_of_exact(difference(coordinate(b, i), coordinate(a, i)) *
                           difference(coordinate(c, k), coordinate(a, k)) -
                       difference(coordinate(b, k), coordinate(a, k)) *
                           difference(coordinate(c, i), coordinate(a, i)));
}

bool is_between(const space_point& p, const space_point& q, const space_point& x, int i, int k) {
  for (const int axis : {i, k}) {
    const double a = coordinate(p, axis), b = coordinate(q, axis), c = coordinate(x, axis);
    if (c < std::min(a, b) || c > std::max(a, b)) return false;
  }
  return true;
}

bool segments_meet(const space_point& p, const space_point& q, const space_point& a,
                   const space_point& b, int i, int k) {
  const int s = turn(p, q, a, i, k), t = turn(p, q, b, i, k), u = turn(a, b, p, i, k),
            v = turn(a, b, q, i, k);
  if (s * t < 0 && u * v < 0) return true;
  return (s == 0 && is_between(p, q, a, i, k)) || (t == 0 && is_between(p, q, b, i, k)) ||
         (u == 0 && is_between(a, b, p, i, k)) || (v == 0 && is_between(a, b, q, i, k));
}

// Tests a segment in the triangle's plane, along an axis in which the triangle has area. A triangle
// without area is its edges.
bool meets_in_plane(const space_point& p, const space_point& q, const corners& t) {
  int i = 0, k = 1;
  for (const auto& [x, y] : {std::array{0, 1}, std::array{1, 2}, std::array{2, 0}})
    if (turn(t[0], t[1], t[2], x, y) != 0) i = x, k = y;
  const int way = turn(t[0], t[1], t[2], i, k);
  bool inside = way != 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const space_point &a = t[n], &b = t[(n + 1) % 3];
    // Requires agreement in all three planes of coordinates for a triangle without area.
    if (way != 0 ? segments_meet(p, q, a, b, i, k)
                 : segments_meet(p, q, a, b, 0, 1) && segments_meet(p, q, a, b, 1, 2) &&
                       segments_meet(p, q, a, b, 2, 0))
      return true;
    inside = inside && turn(a, b, p, i, k) * way >= 0;
  }
  return inside;
}

bool meets(const space_point& p, const space_point& q, const corners& t) {
  const int s = side(t[0], t[1], t[2], p), u = side(t[0], t[1], t[2], q);
  if (s * u > 0) return false;
  if (s == 0 && u == 0) return meets_in_plane(p, q, t);
  int low = 0, high = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const int by = side(p, q, t[n], t[(n + 1) % 3]);
    low = std::min(low, by), high = std::max(high, by);
  }
  return low >= 0 || high <= 0;
}

bool cross_each_other(const space_mesh& m, std::uint32_t first, std::uint32_t second) {
  const space_triangle &f = m.triangles[first], &g = m.triangles[second];
  const auto of = [&](const space_triangle& t) {
    return corners{m.points[t[0]], m.points[t[1]], m.points[t[2]]};
  };
  const corners a = of(f), b = of(g);
  std::vector<std::size_t> common, beside_f, beside_g;
  for (std::size_t k = 0; k < 3; ++k)
    (std::find(g.begin(), g.end(), f[k]) != g.end() ? common : beside_f).push_back(k);
  for (std::size_t k = 0; k < 3; ++k)
    if (std::find(f.begin(), f.end(), g[k]) == f.end()) beside_g.push_back(k);
  if (common.size() == 3) return true;
  if (common.size() == 2) {
    const space_point &p = a[common[0]], &q = a[common[1]], &x = a[beside_f[0]],
                      &y = b[beside_g[0]];
    if (side(p, q, x, y) != 0) return false;
    for (const auto& [i, k] : {std::array{0, 1}, std::array{1, 2}, std::array{2, 0}})
      if (const int way = turn(p, q, x, i, k); way != 0) return way * turn(p, q, y, i, k) > 0;
    return true;  // without area
  }
  if (common.size() == 1)
    return meets(a[beside_f[0]], a[beside_f[1]], b) || meets(b[beside_g[0]], b[beside_g[1]], a);
  for (std::size_t k = 0; k < 3; ++k)
    if (meets(a[k], a[(k + 1) % 3], b) || meets(b[k], b[(k + 1) % 3], a)) return true;
  return false;
}

bool overlap(const space_box& a, const space_box& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.low[k] > b.high[k] || b.low[k] > a.high[k]) return false;
  return true;
}

}  // namespace

std::optional<std::array<std::uint32_t, 2>> crossing_triangles(const space_mesh& m) {
  const std::vector<space_box> boxes = boxes_of_triangles(m);
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].low[0] != boxes[b].low[0] ? boxes[a].low[0] < boxes[b].low[0] : a < b;
  });
  constexpr std::uint32_t none = ~0U;
  std::vector<std::uint32_t> crossed(order.size(), none);
  parallel_for(order.size(), [&](std::size_t k) {
    const std::uint32_t a = order[k];
    for (std::size_t n = k + 1; n < order.size() && crossed[k] == none; ++n) {
      const std::uint32_t b = order[n];
      if (boxes[b].low[0] > boxes[a].high[0]) break;
      if (overlap(boxes[a], boxes[b]) && cross_each_other(m, a, b)) crossed[k] = b;
    }
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    if (crossed[k] != none) return std::array{order[k], crossed[k]};
  return std::nullopt;
}

}  // namespace asterism::internal
