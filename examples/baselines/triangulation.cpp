// SPDX-License-Identifier: MIT
#include "triangulation.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace baselines {
namespace {

using asterism::sign;

std::size_t corner_at(const triangle& t, index v) {
  return static_cast<std::size_t>(std::find(t.corner.begin(), t.corner.end(), v) -
                                  t.corner.begin());
}

}  // namespace

bool triangulation::turns_left(const point& a, const point& b, const point& c) const {
  return kernel_.orientation(a, b, c) == sign::positive;
}

std::optional<triangulation> triangulation::of_polygon(const std::vector<point>& ring) {
  triangulation made;
  made.points_ = ring;
  made.triangle_at_.assign(ring.size(), none);
  made.border_ = ring.size();
  std::vector<index> all(ring.size());
  std::iota(all.begin(), all.end(), index{0});
  const auto ears = made.cut_ears(std::move(all));
  if (!ears) return std::nullopt;
  made.replace({}, *ears);
  return made;
}

// An ear is a convex corner whose triangle contains no other vertex of the ring. A simple polygon
// always has one. The walk begins behind the last ear, so that ears are not all cut at one vertex.
std::optional<std::vector<corners>> triangulation::cut_ears(std::vector<index> ring) const {
  std::vector<corners> made;
  std::size_t at = 0, tried = 0;
  while (ring.size() > 2) {
    if (tried++ > ring.size()) return std::nullopt;
    const std::size_t n = ring.size();
    at = (at + 1) % n;
    const index a = ring[(at + n - 1) % n], b = ring[at], c = ring[(at + 1) % n];
    const point &p = points_[a], &q = points_[b], &r = points_[c];
    if (!turns_left(p, q, r)) continue;
    const bool empty = std::none_of(ring.begin(), ring.end(), [&](index v) {
      const point& s = points_[v];
      return v != a && v != b && v != c && !turns_left(q, p, s) && !turns_left(r, q, s) &&
             !turns_left(p, r, s);
    });
    if (!empty) continue;
    made.push_back({a, b, c});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
    tried = 0;
  }
  return made;
}

// Old and new triangles cover the same polygon. Edges on its border keep their outer triangles.
void triangulation::replace(const std::vector<index>& old, const std::vector<corners>& made) {
  std::map<std::pair<index, index>, std::pair<index, std::size_t>> waiting;  // edges without a twin
  std::map<std::pair<index, index>, index> outside;
  for (const index t : old)
    for (std::size_t k = 0; k < 3; ++k) {
      const corners& c = triangles_[t].corner;
      outside[{c[(k + 1) % 3], c[(k + 2) % 3]}] = triangles_[t].across[k];
    }
  for (const index t : old) {
    triangles_[t] = {};
    free_.push_back(t);
  }
  for (const corners& c : made) {
    if (free_.empty()) {
      free_.push_back(triangles_.size());
      triangles_.emplace_back();
    }
    const index t = free_.back();
    free_.pop_back();
    triangles_[t].corner = c;
    last_ = t;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle_at_[c[k]] = t;
      const index from = c[(k + 1) % 3], to = c[(k + 2) % 3];
      if (const auto twin = waiting.find({to, from}); twin != waiting.end()) {
        const auto [other, j] = twin->second;
        triangles_[t].across[k] = other;
        triangles_[other].across[j] = t;
        waiting.erase(twin);
      } else {
        waiting[{from, to}] = {t, k};
      }
    }
  }
  for (const auto& [edge, place] : waiting) {
    const auto found = outside.find(edge);
    const index beyond = found == outside.end() ? none : found->second;
    triangles_[place.first].across[place.second] = beyond;
    if (beyond == none) continue;
    triangle& there = triangles_[beyond];
    there.across[3 - corner_at(there, edge.first) - corner_at(there, edge.second)] = place.first;
  }
}

index triangulation::locate(const point& p) const {
  const auto beyond = [&](index t) -> std::size_t {  // an edge with p on its other side, or 3
    const corners& c = triangles_[t].corner;
    for (std::size_t i = 0; i < 3; ++i) {
      // Begins at no fixed edge: a walk with a preferred edge may circle.
      const std::size_t k = (i + t) % 3;
      if (turns_left(points_[c[(k + 2) % 3]], points_[c[(k + 1) % 3]], p)) return k;
    }
    return 3;
  };
  index t = last_;
  for (std::size_t steps = 0; steps < triangles_.size() && t != none && triangles_[t].alive();
       ++steps) {
    const std::size_t k = beyond(t);
    if (k == 3) return last_ = t;
    t = triangles_[t].across[k];
  }
  for (t = 0; t < triangles_.size(); ++t)
    if (triangles_[t].alive() && beyond(t) == 3) return last_ = t;
  return none;
}

std::vector<index> triangulation::around(index v) const {
  std::vector<index> found;
  index t = triangle_at_[v];
  const auto turn = [&](std::size_t by) {
    t = triangles_[t].across[(corner_at(triangles_[t], v) + by) % 3];
  };
  if (on_border(v)) {  // clockwise to the first one
    index first = t;
    for (; t != none; turn(2)) first = t;
    t = first;
  }
  const index begin = t;
  do {
    found.push_back(t);
    turn(1);
  } while (t != none && t != begin);
  return found;
}

std::vector<index> triangulation::neighbours(index v) const {
  std::vector<index> found;
  for (const index t : around(v)) {
    const triangle& here = triangles_[t];
    const std::size_t k = corner_at(here, v);
    if (found.empty() || found.back() != here.corner[(k + 1) % 3])
      found.push_back(here.corner[(k + 1) % 3]);
    found.push_back(here.corner[(k + 2) % 3]);
  }
  if (found.front() == found.back()) found.pop_back();
  return found;
}

index triangulation::insert(const point& p, const std::vector<index>& cavity) {
  std::vector<corners> made;
  const index v = points_.size();
  for (const index t : cavity)
    for (std::size_t k = 0; k < 3; ++k) {
      const index beyond = triangles_[t].across[k];
      if (beyond != none && std::find(cavity.begin(), cavity.end(), beyond) != cavity.end())
        continue;
      const index a = triangles_[t].corner[(k + 1) % 3], b = triangles_[t].corner[(k + 2) % 3];
      if (!turns_left(points_[a], points_[b], p)) return none;
      made.push_back({a, b, v});
    }
  // The cavity contains a vertex, which would be lost.
  if (made.size() != cavity.size() + 2) return none;
  points_.push_back(p);
  triangle_at_.push_back(none);
  replace(cavity, made);
  return v;
}

std::vector<index> triangulation::cell_of(const point& p) const {
  const index t = locate(p);
  if (t == none) return {};
  std::vector<index> cell = {t};
  const corners& c = triangles_[t].corner;
  for (std::size_t k = 0; k < 3; ++k) {
    if (points_[c[k]] == p) return {};
    if (turns_left(points_[c[(k + 1) % 3]], points_[c[(k + 2) % 3]], p)) continue;
    if (triangles_[t].across[k] == none) return {};
    cell.push_back(triangles_[t].across[k]);
  }
  return cell;
}

bool triangulation::sees_border(const point& p, index t, const std::vector<index>& cavity) const {
  const triangle& here = triangles_[t];
  for (std::size_t k = 0; k < 3; ++k) {
    const point &a = points_[here.corner[(k + 1) % 3]], &b = points_[here.corner[(k + 2) % 3]];
    const bool inside = std::find(cavity.begin(), cavity.end(), here.across[k]) != cavity.end();
    if (!inside && !turns_left(a, b, p)) return false;
  }
  return true;
}

bool triangulation::remove(index v) {
  const auto ears = cut_ears(neighbours(v));
  if (!ears) return false;
  replace(around(v), *ears);
  triangle_at_[v] = none;
  return true;
}

bool triangulation::move(index v, const point& to) {
  for (const index t : around(v)) {
    const corners& c = triangles_[t].corner;
    const std::size_t k = corner_at(triangles_[t], v);
    if (!turns_left(to, points_[c[(k + 1) % 3]], points_[c[(k + 2) % 3]])) return false;
  }
  points_[v] = to;
  return true;
}

// Flips if the quadrilateral is convex and y is inside the circle of v, w, x.
bool triangulation::flip(index t, std::size_t k, const metric_of_edge& metric) {
  const triangle& here = triangles_[t];
  const index other = here.across[k];
  if (other == none) return false;
  const triangle& there = triangles_[other];
  const index x = here.corner[k], v = here.corner[(k + 1) % 3], w = here.corner[(k + 2) % 3];
  const index y = there.corner[3 - corner_at(there, v) - corner_at(there, w)];
  const point &px = points_[x], &pv = points_[v], &pw = points_[w], &py = points_[y];
  if (!turns_left(px, pv, py) || !turns_left(py, pw, px)) return false;
  if (kernel_.in_circle(metric(v, w, x, y), px, pv, pw, py) != sign::positive) return false;
  replace({t, other}, {{x, v, y}, {x, y, w}});
  return true;
}

std::size_t triangulation::flip_from(std::vector<index> waiting, const metric_of_edge& metric,
                                     std::size_t most) {
  std::size_t flips = 0;
  while (!waiting.empty() && flips < most) {
    const index t = waiting.back();
    waiting.pop_back();
    if (!triangles_[t].alive()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const index other = triangles_[t].across[k];
      if (!flip(t, k, metric)) continue;
      ++flips;
      waiting.push_back(other);
      waiting.push_back(t);
      break;
    }
  }
  return flips;
}

std::size_t triangulation::flip_all(const metric_of_edge& metric) {
  std::vector<index> all(triangles_.size());
  std::iota(all.rbegin(), all.rend(), index{0});
  return flip_from(std::move(all), metric, 20 * triangles_.size());
}

}  // namespace baselines
