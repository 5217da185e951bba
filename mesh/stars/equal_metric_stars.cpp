// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/equal_metric_stars.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "asterism/mesh/stars/canonical_triangle.hpp"
#include "asterism/mesh/stars/site_triangulation.hpp"
#include "asterism/mesh/support/infinity.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

// Returns the radius of the circle around a triangle in its metric, rounded up: the product of its
// sides over four times its area. A length is off by at most 2^-46 of its monomials, an area by
// 2^-49. Infinite where these errors are too large, or near underflow or overflow.
double circumradius_above(const site& v, const point& q, const point& r) {
  const metric_tensor& m = v.metric;
  const auto squared_above = [&](double x, double y) {
    const double xx = m.m11 * x * x, yy = m.m22 * y * y;
    return xx + yy + 2 * (m.m12 * x * y) + 0x1p-46 * (xx + yy);
  };
  const double ax = q.x - v.position.x, ay = q.y - v.position.y, bx = r.x - v.position.x,
               by = r.y - v.position.y;
  const double left = ax * by, right = ay * bx;
  const double twice_area = left - right - 0x1p-49 * (std::abs(left) + std::abs(right));
  const double product = m.m11 * m.m22, square = m.m12 * m.m12;
  const double determinant = product - square - 0x1p-49 * (product + square);
  const double sides =
      squared_above(ax, ay) * squared_above(bx, by) * squared_above(r.x - q.x, r.y - q.y);
  const double below = 4 * determinant * (twice_area * twice_area);
  constexpr double smallest = 0x1p-900, largest = 0x1p900;
  const bool in_range = twice_area > 0 && determinant > 0 && sides > smallest && sides < largest &&
                        below > smallest && below < largest;
  return in_range ? std::sqrt(sides / below) * (1 + 0x1p-40) : infinity;
}

// Reads stars from the triangulation. Each star proves those faces of which its site has the least
// number.
class star_reader {
 public:
  star_reader(const site_oracle& oracle, const site_triangulation& from,
              const star_predicates& kernel)
      : oracle_(oracle), from_(from), kernel_(kernel) {}

  // Returns the star of v; none if a face is not proved or an end of a sector is missing.
  std::optional<constructed_star> read(vertex_index v) {
    constructed_star built{empty_star(oracle_.edges(), v), true, false, {}};
    reach_ = 0;
    for (sector& s : built.content.sectors)
      if (!fill(v, s)) return std::nullopt;
    built.final_reach = reach_;
    return built;
  }

 private:
  using face = delaunay_triangulation::face;
  using place = delaunay_triangulation::place;

  static std::uint32_t after(std::uint32_t i) { return i == 2 ? 0 : i + 1; }

  // Fills in a sector, from end to end or all around, beginning with the nearest neighbour.
  bool fill(vertex_index v, sector& s) {
    const vertex_index centre = from_.numbers[v];
    place p = from_.delaunay.at(centre);
    if (!s.closed && !turn_to(p, from_.numbers[s.neighbours.front()])) return false;
    const std::uint32_t first = p.face;
    ring_.clear();
    do {
      if (!take(p)) return false;
      const face& f = from_.delaunay.faces()[p.face];
      ring_.push_back(from_.original[f.corner[after(p.corner)]]);
      const vertex_index next = from_.original[f.corner[after(after(p.corner))]];
      if (!s.closed && next == s.neighbours.back()) {
        ring_.push_back(next);
        s.neighbours.assign(ring_.begin(), ring_.end());
        return true;
      }
      p = from_.delaunay.next_around(p);
    } while (p.face != first);
    if (!s.closed) return false;
    std::rotate(ring_.begin(), nearest(v), ring_.end());
    s.neighbours.assign(ring_.begin(), ring_.end());
    return true;
  }

  std::vector<vertex_index>::iterator nearest(vertex_index v) {
    return std::min_element(ring_.begin(), ring_.end(), [&](vertex_index a, vertex_index b) {
      return oracle_.squared_distance(v, a) < oracle_.squared_distance(v, b);
    });
  }

  // Rotates the place p around its corner until the edge to `end` is the first one of its face.
  bool turn_to(place& p, vertex_index end) const {
    const std::uint32_t first = p.face;
    do {
      if (from_.delaunay.faces()[p.face].corner[after(p.corner)] == end) return true;
      p = from_.delaunay.next_around(p);
      if (p.face == delaunay_triangulation::none) return false;
    } while (p.face != first);
    return false;
  }

  // Adds the face to the star; false if it is not proved Delaunay, or reaches out of the domain.
  // The reach becomes infinite where a subsegment closes the gap, as a split of the subsegment
  // would open the gap.
  bool take(const place& p) {
    const face& f = from_.delaunay.faces()[p.face];
    for (const vertex_index corner : f.corner)
      if (from_.delaunay.is_frame(corner)) return false;
    const vertex_index v = f.corner[p.corner];
    const bool is_first = v == *std::min_element(f.corner.begin(), f.corner.end());
    if (is_first && !from_.delaunay.is_sound(p.face, kernel_)) return false;
    const auto& sites = from_.delaunay.all_sites();
    const double radius =
        f.fixed[p.corner] ? infinity
                          : circumradius_above(sites[v], sites[f.corner[after(p.corner)]].position,
                                               sites[f.corner[after(after(p.corner))]].position);
    reach_ = std::max(reach_, radius);
    return true;
  }

  const site_oracle& oracle_;
  const site_triangulation& from_;
  const star_predicates& kernel_;
  std::vector<vertex_index> ring_;
  double reach_ = 0;
};

bool have_one_metric(const std::vector<site>& sites) {
  return std::all_of(sites.begin(), sites.end(),
                     [&](const site& s) { return identical(s.metric, sites.front().metric); });
}

// Collects the faces inside the domain as triangles, by the sites' own numbers. Leaves out faces
// that reach out of the domain and, if stars are confirmed by_mesher, faces that are not sound.
std::vector<triangle> sound_triangles(const site_oracle& oracle, const site_triangulation& from,
                                      const std::vector<char>& inside,
                                      star_confirmation confirmed) {
  constexpr std::size_t chunk = 2048;
  std::vector<tier_counters> counts(chunk_count(inside.size(), chunk));
  std::vector<triangle> all = collect_chunks<triangle>(
      inside.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<triangle>& out) {
        const auto kernel = oracle.kernel().fork(counts[begin / chunk]);
        for (std::size_t f = begin; f < end; ++f) {
          if (inside[f] == 0) continue;
          const auto& corner = from.delaunay.faces()[f].corner;
          const bool framed = std::any_of(corner.begin(), corner.end(), [&](vertex_index v) {
            return from.delaunay.is_frame(v);
          });
          const bool is_sound = confirmed == star_confirmation::by_auditor ||
                                from.delaunay.is_sound(static_cast<std::uint32_t>(f), *kernel);
          if (framed || !is_sound) return;
          out.push_back(canonical(
              {from.original[corner[0]], from.original[corner[1]], from.original[corner[2]]}));
        }
      });
  for (const tier_counters& c : counts) oracle.kernel().counters() += c;
  return all;
}

// Sorts triangles whose least corner comes first: by counting for that corner, and by comparing
// those that share it.
std::vector<triangle> in_order(const std::vector<triangle>& triangles, std::size_t sites) {
  std::vector<std::size_t> start(sites + 1, 0);
  for (const triangle& t : triangles) ++start[t[0] + 1];
  for (std::size_t v = 0; v < sites; ++v) start[v + 1] += start[v];
  std::vector<triangle> sorted(triangles.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const triangle& t : triangles) sorted[next[t[0]]++] = t;
  const auto at = [&](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t v = 0; v < sites; ++v) std::sort(at(start[v]), at(start[v + 1]));
  return sorted;
}

// True if every site, by its number below `sites`, is a corner of a triangle.
bool use_all(const std::vector<triangle>& triangles, std::size_t sites) {
  std::vector<char> used(sites, 0);
  for (const triangle& t : triangles)
    for (const vertex_index v : t) used[v] = 1;
  return std::find(used.begin(), used.end(), 0) == used.end();
}

}  // namespace

std::optional<std::vector<triangle>> triangles_of_equal_metrics(const site_oracle& oracle,
                                                                const cancellation& cancelled,
                                                                star_confirmation confirmed) {
  if (oracle.size() < 3 || !have_one_metric(oracle.sites())) return std::nullopt;
  auto from = triangulate(oracle, oracle.sites().front().metric, oracle.kernel(), cancelled);
  if (!from) return std::nullopt;
  const std::vector<char> inside = faces_inside(*from, oracle.edges());
  const auto count = static_cast<std::size_t>(std::count(inside.begin(), inside.end(), char{1}));
  const std::vector<triangle> all = sound_triangles(oracle, *from, inside, confirmed);
  from.reset();  // makes room
  if (all.size() != count || !use_all(all, oracle.size())) return std::nullopt;
  return in_order(all, oracle.size());
}

std::optional<std::vector<constructed_star>> stars_of_equal_metrics(const site_oracle& oracle,
                                                                    const cancellation& cancelled) {
  if (oracle.size() < 3 || !have_one_metric(oracle.sites())) return std::nullopt;
  const auto from = triangulate(oracle, oracle.sites().front().metric, oracle.kernel(), cancelled);
  if (!from) return std::nullopt;
  constexpr std::size_t chunk = 1024;
  std::vector<tier_counters> counts(chunk_count(oracle.size(), chunk));
  std::vector<char> is_made(counts.size(), 0);
  // Writes the stars in place: a large mesh has its peak of memory here.
  std::vector<constructed_star> stars(oracle.size());
  parallel_chunks(stars.size(), chunk, [&](std::size_t i, std::size_t begin, std::size_t end) {
    const auto kernel = oracle.kernel().fork(counts[i]);
    star_reader reader(oracle, *from, *kernel);
    for (std::size_t v = begin; v < end; ++v) {
      auto made = reader.read(static_cast<vertex_index>(v));
      if (!made) return;
      stars[v] = std::move(*made);
    }
    is_made[i] = 1;
  });
  for (const tier_counters& c : counts) oracle.kernel().counters() += c;
  if (std::find(is_made.begin(), is_made.end(), 0) != is_made.end()) return std::nullopt;
  return stars;
}

}  // namespace asterism::internal
