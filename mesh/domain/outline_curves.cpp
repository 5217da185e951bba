// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/outline_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/domain/curve_path.hpp"
#include "asterism/mesh/domain/curve_separation.hpp"
#include "asterism/mesh/domain/point_algebra.hpp"

namespace asterism::internal {
namespace {

double length(const point& a) { return elementary::hypot(a.x, a.y); }
point unit(const point& a) {
  const double l = length(a);
  return {a.x / l, a.y / l};
}

}  // namespace

// Returns the neighbour of a smooth vertex that is not `from`.
vertex_index outline_curves::beyond(vertex_index v, vertex_index from) const {
  const boundary_edge &e = mesh_.boundary[at_[v][0]], &f = mesh_.boundary[at_[v][1]];
  const vertex_index p = e.a == v ? e.b : e.a, q = f.a == v ? f.b : f.a;
  return p == from ? q : p;
}

// Returns the absolute angle by which the boundary turns at a smooth vertex.
double outline_curves::turn_at(vertex_index v, vertex_index from) const {
  const point u = minus(where(v), where(from)), w = minus(where(beyond(v, from)), where(v));
  return elementary::atan2(std::abs(u.x * w.y - u.y * w.x), dot(u, w));
}

bool outline_curves::is_straight(vertex_index a, vertex_index b) const {
  constexpr double part = 1.0 / 20;
  if (smooth_[a] == 0 || smooth_[b] == 0) return smooth_[a] == smooth_[b];
  const double at_a = turn_at(a, b), at_b = turn_at(b, a);
  return std::min(at_a, at_b) < part * std::max(at_a, at_b);
}

// Returns the unit vector in which the boundary leaves v for its neighbour `to`.
std::optional<point> outline_curves::direction(vertex_index v, vertex_index to) const {
  const point ahead = minus(where(to), where(v));
  if (is_straight(v, to)) return unit(ahead);
  if (smooth_[v] == 0) return std::nullopt;
  const vertex_index from = beyond(v, to);
  const point behind = minus(where(v), where(from));
  if (is_straight(from, v)) return unit(behind);
  // Returns the tangent of the circle through three points. It makes with each chord half of the
  // angle that the chord spans, whose sine is proportional to the chord: so each unit vector is
  // weighted by the length of the other chord.
  const double l = length(behind), r = length(ahead);
  return unit({behind.x / l * r + ahead.x / r * l, behind.y / l * r + ahead.y / r * l});
}

std::optional<std::array<point, 2>> outline_curves::control(const vertex_index* first,
                                                            std::size_t count) const {
  const vertex_index a = first[0], b = first[count - 1];
  auto start = direction(a, first[1]), end = direction(b, first[count - 2]);
  if (!start && !end) return std::nullopt;
  const point chord = minus(where(b), where(a));
  const double whole = length(chord);
  const point c = unit(chord);
  const auto mirrored = [&c](const point& t) {
    return point{t.x - 2 * dot(t, c) * c.x, t.y - 2 * dot(t, c) * c.y};
  };
  if (!start) start = mirrored(*end);
  if (!end) end = mirrored(*start);
  const double at_start = dot(*start, c), at_end = -dot(*end, c);
  constexpr double least = 0.5;  // the cosine of 60 degrees
  if (!(at_start > least && at_end > least)) return std::nullopt;
  // Computes the distance of the control points from the ends as for an arc whose tangents at the
  // ends make this angle with the chord.
  const double from_a = 2 * whole / (3 * (1 + at_start)), from_b = 2 * whole / (3 * (1 + at_end));
  return std::array<point, 2>{{{where(a).x + from_a * start->x, where(a).y + from_a * start->y},
                               {where(b).x + from_b * end->x, where(b).y + from_b * end->y}}};
}

void drop_curves_in_the_way(domain& shape) {
  if (shape.curves.empty()) return;
  std::vector<curve_path> paths;
  for (const domain_curve& c : shape.curves)
    paths.emplace_back(c, shape.vertices[c.vertices[0]], shape.vertices[c.vertices[1]]);
  const std::vector<char> meet = curves_in_contact(shape, paths);
  std::vector<domain_curve> kept;
  for (std::size_t c = 0; c < meet.size(); ++c)
    if (meet[c] == 0) kept.push_back(std::move(shape.curves[c]));
  shape.curves = std::move(kept);
}

bool bring_to_order(const domain& before, const domain& now,
                    std::vector<std::vector<point>>& between) {
  const auto ends = [](const domain& d, const segment& s) {
    std::array<std::array<double, 2>, 2> e = {
        {{d.vertices[s.a].x, d.vertices[s.a].y}, {d.vertices[s.b].x, d.vertices[s.b].y}}};
    if (e[1] < e[0]) std::swap(e[0], e[1]);
    return e;
  };
  std::map<std::array<std::array<double, 2>, 2>, std::size_t> place;
  for (std::size_t s = 0; s < before.segments.size(); ++s)
    place[ends(before, before.segments[s])] = s;
  std::vector<std::vector<point>> ordered;
  for (const segment& s : now.segments) {
    const auto found = place.find(ends(now, s));
    if (found == place.end()) return false;
    ordered.push_back(between[found->second]);
    if (!(before.vertices[before.segments[found->second].a] == now.vertices[s.a]))
      std::reverse(ordered.back().begin(), ordered.back().end());
  }
  between = std::move(ordered);
  return true;
}

}  // namespace asterism::internal
