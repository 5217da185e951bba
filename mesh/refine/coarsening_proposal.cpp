// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/coarsening_proposal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr std::size_t chunk = 256;
// Most sides of a hole whose triangulations are searched, which takes the cube of their number. A
// site with more neighbours is needed by many.
constexpr std::size_t most_sides = 12;
// Angle in degrees above which a move may spoil one for the sake of the others.
constexpr double comfortable_angle = 30;
constexpr int sweeps = 4;
// Smallest gain in summed quality that justifies rebuilding a site's stars.
constexpr double least_gain = 1e-3;

struct judgement {
  double angle = 0, quality = 0, radius = 0;
};

struct hole {
  vertex_index site = 0;
  double gain =
      0;  // of the sum of qualities over what keeps the mean as it is, two triangles fewer
  std::vector<triangle> filled_by;
};

// Triangulates the part first..last of a ring; `apex` holds the third corner chosen for each part.
std::vector<triangle> triangles_below(
    const std::vector<vertex_index>& ring,
    const std::array<std::array<std::size_t, most_sides>, most_sides>& apex) {
  std::vector<triangle> found;
  std::vector<std::array<std::size_t, 2>> parts{{0, ring.size() - 1}};
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    if (last == first + 1) continue;
    const std::size_t k = apex[first][last];
    found.push_back({ring[first], ring[k], ring[last]});
    parts.push_back({first, k});
    parts.push_back({k, last});
  }
  return found;
}

// Returns the triangulation of a ring, counter-clockwise, whose least `worth` of a triangle is
// greatest, by dynamic programming over its parts first..last. Empty where each has a triangle of
// no worth, which is less than 0, and where the ring has fewer than three sides or too many.
template <class Worth>
std::vector<triangle> best_ring_triangulation(const std::vector<vertex_index>& ring,
                                              const Worth& worth) {
  const std::size_t n = ring.size();
  if (n < 3 || n > most_sides) return {};
  std::array<std::array<double, most_sides>, most_sides> best{};
  std::array<std::array<std::size_t, most_sides>, most_sides> apex{};
  for (std::size_t i = 0; i + 1 < n; ++i) best[i][i + 1] = 180;
  for (std::size_t width = 2; width < n; ++width)
    for (std::size_t first = 0; first + width < n; ++first) {
      const std::size_t last = first + width;
      best[first][last] = -1;
      for (std::size_t k = first + 1; k < last; ++k) {
        double least = std::min(best[first][k], best[k][last]);
        if (least <= best[first][last]) continue;
        least = std::min(least, worth({ring[first], ring[k], ring[last]}));
        if (least <= best[first][last]) continue;
        best[first][last] = least;
        apex[first][last] = k;
      }
    }
  if (best[0][n - 1] < 0) return {};
  return triangles_below(ring, apex);
}

// Changes a triangulation step by step into the one proposed.
class coarsening {
 public:
  coarsening(const mesh& m, const metric_field& field, const improvement_goal& goal,
             const std::vector<char>& barred)
      : mesh_(m), field_(field), goal_(goal), sites_(m.sites), free_(m.sites.size(), 1) {
    for (vertex_index v = 0; v < sites_.size(); ++v)
      free_[v] = v >= m.given && barred[v] == 0 ? 1 : 0;
    for (const boundary_edge& e : m.boundary) free_[e.a] = free_[e.b] = 0;
    removed_.assign(sites_.size(), 0);
    moved_.assign(sites_.size(), 0);
    triangles_at_.resize(sites_.size());
    for (const triangle& t : m.triangles) add(t);
  }

  void remove_what_is_not_needed() {
    std::vector<hole> holes = collect_chunks<hole>(
        sites_.size(), chunk, [&](std::size_t begin, std::size_t end, std::vector<hole>& out) {
          for (std::size_t v = begin; v < end; ++v)
            if (auto h = hole_of(static_cast<vertex_index>(v))) out.push_back(std::move(*h));
        });
    std::sort(holes.begin(), holes.end(), [](const hole& a, const hole& b) {
      return a.gain != b.gain ? a.gain > b.gain : a.site < b.site;
    });
    std::vector<char> needed(sites_.size(), 0);
    for (const hole& h : holes) {
      if (needed[h.site] != 0) continue;
      for (const triangle& t : h.filled_by)
        for (const vertex_index u : t) needed[u] = 1;
      remove(h);
    }
  }

  void smooth() {
    judged_ = collect_chunks<judgement>(
        triangles_.size(), chunk,
        [&](std::size_t begin, std::size_t end, std::vector<judgement>& out) {
          for (std::size_t i = begin; i < end; ++i) out.push_back(judge(sites_of(triangles_[i])));
        });
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (vertex_index v = 0; v < sites_.size(); ++v)
        if (free_[v] != 0 && removed_[v] == 0) move(v);
  }

  improvement_proposal proposal(std::size_t segments) const {
    improvement_proposal p;
    p.filling.complete = true;
    p.removed = removals_;
    p.filling.divisions.resize(segments);
    const std::vector<boundary_edge>& subsegments = mesh_.boundary;
    for (std::size_t i = 0; i + 1 < subsegments.size(); ++i)
      if (subsegments[i].segment == subsegments[i + 1].segment)
        p.filling.divisions[subsegments[i].segment].push_back(sites_[subsegments[i].b]);
    const std::vector<char> twice = at_an_earlier_place();
    std::vector<char> on_boundary(sites_.size(), 0);
    for (const boundary_edge& e : subsegments) on_boundary[e.a] = on_boundary[e.b] = 1;
    for (vertex_index v = 0; v < sites_.size(); ++v) {
      p.places.push_back(sites_[v].position);
      if (moved_[v] != 0) p.moved.push_back(v);
      if (v >= mesh_.given && on_boundary[v] == 0 && removed_[v] == 0 && twice[v] == 0)
        p.filling.interior.push_back(sites_[v]);
    }
    return p;
  }

 private:
  // Marks sites at the place of an earlier one, as refinement requires distinct sites. Sites do not
  // meet while triangles keep the orientation that doubles compute.
  std::vector<char> at_an_earlier_place() const {
    std::vector<vertex_index> order;
    for (vertex_index v = 0; v < sites_.size(); ++v)
      if (removed_[v] == 0) order.push_back(v);
    const auto at = [this](vertex_index v) -> const point& { return sites_[v].position; };
    // Sites that have not moved come first within a place: they may be ones that have to stay.
    std::sort(order.begin(), order.end(), [&](vertex_index v, vertex_index w) {
      if (at(v) == at(w)) return std::pair(moved_[v], v) < std::pair(moved_[w], w);
      return lexicographically_less(at(v), at(w));
    });
    std::vector<char> found(sites_.size(), 0);
    for (std::size_t i = 1; i < order.size(); ++i)
      found[order[i]] = at(order[i]) == at(order[i - 1]) ? 1 : 0;
    return found;
  }

  triangle_sites sites_of(const triangle& t) const {
    return {sites_[t[0]], sites_[t[1]], sites_[t[2]]};
  }

  static judgement judge(const triangle_sites& t) {
    return {asterism::internal::smallest_angle(t), shape_of(t).quality, metric_circumradius(t)};
  }

  void add(const triangle& t) {
    for (const vertex_index v : t) triangles_at_[v].push_back(triangles_.size());
    triangles_.push_back(t);
  }

  // Returns the neighbours of v counter-clockwise; none where the triangles do not close around it.
  std::vector<vertex_index> ring(vertex_index v) const {
    std::vector<std::array<vertex_index, 2>> sides;
    for (const std::size_t i : triangles_at_[v]) {
      const triangle& t = triangles_[i];
      const std::size_t at = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      sides.push_back({t[(at + 1) % 3], t[(at + 2) % 3]});
    }
    std::vector<vertex_index> found;
    if (sides.size() < 3) return found;
    vertex_index next = sides[0][0];
    for (std::size_t step = 0; step < sides.size(); ++step) {
      const auto side =
          std::find_if(sides.begin(), sides.end(), [next](const auto& s) { return s[0] == next; });
      if (side == sides.end()) return {};
      found.push_back(next);
      next = (*side)[1];
      if (next == found[0] && step + 1 < sides.size()) return {};
    }
    return next == found[0] ? found : std::vector<vertex_index>{};
  }

  // Returns the triangle's smallest angle in degrees; -1 where it misses the goal.
  double worth(const triangle& t) const {
    const triangle_sites s = sites_of(t);
    const double angle = shape_of(s).area > 0 ? asterism::internal::smallest_angle(s) : -1;
    if (!(angle >= goal_.least_angle)) return -1;
    if (goal_.largest_radius < std::numeric_limits<double>::infinity() &&
        !(metric_circumradius(s) <= goal_.largest_radius))
      return -1;
    return angle;
  }

  // Returns the best filling of the hole that v leaves; none where v has to stay.
  std::optional<hole> hole_of(vertex_index v) const {
    if (free_[v] == 0) return std::nullopt;
    hole found{v, 0, {}};
    found.filled_by =
        best_ring_triangulation(ring(v), [this](const triangle& t) { return worth(t); });
    if (found.filled_by.empty()) return std::nullopt;
    found.gain = 2 * goal_.mean_quality;
    for (const triangle& t : found.filled_by) found.gain += shape_of(sites_of(t)).quality;
    for (const std::size_t i : triangles_at_[v])
      found.gain -= shape_of(sites_of(triangles_[i])).quality;
    return found;
  }

  // Puts the triangles of the hole, two fewer, in place of those at the site.
  void remove(const hole& h) {
    std::vector<std::size_t> room;
    std::swap(room, triangles_at_[h.site]);
    for (const std::size_t i : room)
      for (const vertex_index u : triangles_[i]) std::erase(triangles_at_[u], i);
    for (std::size_t i = 0; i < h.filled_by.size(); ++i) {
      triangles_[room[i]] = h.filled_by[i];
      for (const vertex_index u : h.filled_by[i]) triangles_at_[u].push_back(room[i]);
    }
    removed_[h.site] = 1;
    removals_.push_back(h.site);
  }

  // Returns the mean of the neighbours, the farther the heavier, as the site measures.
  point mean_of_neighbours(vertex_index v) const {
    double weights = 0;
    point sum{0, 0};  // of displacements
    const point from = sites_[v].position;
    for (const std::size_t i : triangles_at_[v])
      for (const vertex_index u : triangles_[i]) {
        if (u == v) continue;
        const point& to = sites_[u].position;
        const double weight = std::sqrt(squared_distance(sites_[v], to));
        weights += weight;
        sum = {sum.x + weight * (to.x - from.x), sum.y + weight * (to.y - from.y)};
      }
    return {from.x + sum.x / weights, from.y + sum.y / weights};
  }

  void move(vertex_index v) {
    if (triangles_at_[v].size() < 3 || ring(v).empty()) return;
    const point from = sites_[v].position, to = mean_of_neighbours(v);
    for (const double part : {1.0, 0.5}) {
      const point q{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
      if (move_to(v, q)) return;
    }
  }

  bool move_to(vertex_index v, const point& q) {
    if (!std::isfinite(q.x) || !std::isfinite(q.y) || q == sites_[v].position) return false;
    const auto metric = field_.at(q);
    if (!metric) return false;
    const site before = sites_[v];
    sites_[v] = {q, metric.value()};
    judgement old_ones{180, 0, 0}, new_ones{180, 0, 0};
    std::vector<judgement> found;
    for (const std::size_t i : triangles_at_[v]) {
      include(judged_[i], old_ones);
      const triangle_sites t = sites_of(triangles_[i]);
      found.push_back(shape_of(t).area > 0 ? judge(t) : judgement{-1, 0, 0});
      include(found.back(), new_ones);
    }
    if (!is_better(old_ones, new_ones)) {
      sites_[v] = before;
      return false;
    }
    for (std::size_t i = 0; i < found.size(); ++i) judged_[triangles_at_[v][i]] = found[i];
    moved_[v] = 1;
    return true;
  }

  static void include(const judgement& one, judgement& all) {
    all.angle = std::min(all.angle, one.angle);
    all.quality += one.quality;
    all.radius = std::max(all.radius, one.radius);
  }

  bool is_better(const judgement& before, const judgement& after) const {
    return after.quality > before.quality + least_gain &&
           after.angle >= std::min(before.angle, comfortable_angle) &&
           after.radius <= std::max(before.radius, goal_.largest_radius);
  }

  const mesh& mesh_;
  const metric_field& field_;
  const improvement_goal& goal_;
  std::vector<site> sites_;
  std::vector<char> free_, removed_, moved_;  // by site
  std::vector<vertex_index> removals_;
  std::vector<triangle> triangles_;  // those of no site's list are gone
  std::vector<std::vector<std::size_t>> triangles_at_;
  std::vector<judgement> judged_;  // of triangles_
};

}  // namespace

improvement_proposal propose_improvement(const mesh& m, std::size_t segments,
                                         const metric_field& field, const improvement_goal& goal,
                                         const std::vector<char>& barred) {
  coarsening work(m, field, goal, barred);
  work.remove_what_is_not_needed();
  work.smooth();
  return work.proposal(segments);
}

}  // namespace asterism::internal
