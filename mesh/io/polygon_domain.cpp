// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/polygon_domain.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism::internal {
namespace {

struct placed_ring {
  const ring* corners = nullptr;
  bounding_box box;
};

bounding_box box_of(const ring& corners) {
  bounding_box box{corners[0], corners[0]};
  for (const point& p : corners) box.include(p);
  return box;
}

// A place where a horizontal line crosses a ring.
struct crossing {
  double x;
  bool own;  // of the ring that a point is looked for in
};

// Appends the crossings; false where a corner is on the line, for which another line is taken.
bool add_crossings(const ring& corners, double y, bool own, std::vector<crossing>& found) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const point &p = corners[i], &q = corners[(i + 1) % corners.size()];
    if (p.y == y) return false;
    if ((p.y < y) != (q.y < y))
      found.push_back({p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)), own});
  }
  return true;
}

struct place {
  point at;
  double room = 0;
};

// The widest stretch of the line that lies in the ring `which` and begins or ends at it: nothing
// else is between the stretch and the ring.
void look_along(const std::vector<placed_ring>& rings, std::size_t which, double y, double height,
                place& best) {
  std::vector<crossing> found;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const bounding_box &box = rings[r].box, &own = rings[which].box;
    const bool meets =
        box.low.y <= y && y <= box.high.y && box.low.x <= own.high.x && own.low.x <= box.high.x;
    if (meets && !add_crossings(*rings[r].corners, y, r == which, found)) return;
  }
  std::sort(found.begin(), found.end(),
            [](const crossing& a, const crossing& b) { return a.x < b.x; });
  bool inside = false;
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    if (found[i].own) inside = !inside;
    if (!inside || !(found[i].own || found[i + 1].own)) continue;
    const double room = std::min(found[i + 1].x - found[i].x, height);
    if (room > best.room) best = {{found[i].x + (found[i + 1].x - found[i].x) / 2, y}, room};
  }
}

// Looks along lines halfway between the heights, sorted, that follow each other: sixteen, or all.
place look_between(const std::vector<placed_ring>& rings, std::size_t which,
                   std::vector<double> heights) {
  constexpr std::size_t most = 16;
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  place best;
  const std::size_t gaps = heights.size() - 1;
  for (std::size_t k = 0; k < std::min(most, gaps); ++k) {
    const std::size_t i = gaps <= most ? k : k * gaps / most;
    const double height = heights[i + 1] - heights[i];
    look_along(rings, which, heights[i] + height / 2, height, best);
  }
  return best;
}

// Between the ring's own corners first. A line there may meet corners of others, as halfway up a
// square with a square hole; none does between the corners of all.
std::optional<point> point_inside(const std::vector<placed_ring>& rings, std::size_t which) {
  std::vector<double> heights;
  for (const point& p : *rings[which].corners) heights.push_back(p.y);
  place best = look_between(rings, which, heights);
  if (best.room == 0) {
    const bounding_box& own = rings[which].box;
    for (const placed_ring& r : rings)
      for (const point& p : *r.corners)
        if (own.low.y < p.y && p.y < own.high.y) heights.push_back(p.y);
    best = look_between(rings, which, std::move(heights));
  }
  if (best.room > 0) return best.at;
  return std::nullopt;
}

void add_ring(const ring& corners, int marker, domain& d) {
  const auto first = static_cast<vertex_index>(d.vertices.size());
  const auto n = static_cast<vertex_index>(corners.size());
  d.vertices.insert(d.vertices.end(), corners.begin(), corners.end());
  for (vertex_index k = 0; k < n; ++k)
    d.segments.push_back({first + k, first + (k + 1) % n, marker});
}

}  // namespace

void open_ring(ring& corners) {
  while (corners.size() > 1 && corners.front().x == corners.back().x &&
         corners.front().y == corners.back().y)
    corners.pop_back();
}

result<domain> domain_of_polygons(const std::vector<polygon>& polygons, bool regions) {
  std::vector<placed_ring> rings;
  for (const polygon& p : polygons)
    for (const ring& r : p.rings) rings.push_back({&r, box_of(r)});
  domain d;
  std::size_t which = 0;
  for (std::size_t k = 0; k < polygons.size(); ++k)
    for (std::size_t i = 0; i < polygons[k].rings.size(); ++i, ++which) {
      add_ring(*rings[which].corners, static_cast<int>(k) + 1, d);
      if (i == 0 && !regions) continue;
      const auto inside = point_inside(rings, which);
      const std::string name = "polygon " + std::to_string(k + 1);
      if (!inside)
        return error{
            name + ": ring " + std::to_string(i + 1) + " has no inside that could be found",
            error_code::invalid_domain};
      if (i > 0)
        d.holes.push_back(*inside);
      else
        d.regions.push_back({*inside, polygons[k].region});
    }
  return d;
}

}  // namespace asterism::internal
