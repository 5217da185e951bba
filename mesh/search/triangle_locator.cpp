// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/triangle_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr double no_depth = -std::numeric_limits<double>::infinity();

double doubled_area(const point& a, const point& b, const point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<triangle> counter_clockwise(const mesh& m) {
  constexpr std::size_t chunk = 8192;
  const auto append = [&m](std::size_t begin, std::size_t end, std::vector<triangle>& kept) {
    for (std::size_t i = begin; i < end; ++i) {
      const triangle& t = m.triangles[i];
      if (doubled_area(m.sites[t[0]].position, m.sites[t[1]].position, m.sites[t[2]].position) > 0)
        kept.push_back(t);
    }
  };
  return collect_chunks<triangle>(m.triangles.size(), chunk, append);
}

// Computes the weights of the corners at q, and returns the least one. Ends early once a weight is
// below `least`, and returns that.
double find_weights(const std::vector<point>& places, const triangle& t, const point& q,
                    double least, std::array<double, 3>& weights) {
  const point &a = places[t[0]], &b = places[t[1]], &c = places[t[2]];
  const double whole = doubled_area(a, b, c);
  weights[0] = doubled_area(q, b, c) / whole;
  if (weights[0] < least) return weights[0];
  weights[1] = doubled_area(a, q, c) / whole;
  if (weights[1] < least) return weights[1];
  weights[2] = doubled_area(a, b, q) / whole;
  return std::min({weights[0], weights[1], weights[2]});
}

triangle_locator::located without_negative_weights(triangle_locator::located found) {
  for (double& w : found.weights) w = std::max(0.0, w);
  return found;
}

}  // namespace

triangle_locator::triangle_locator(const mesh& m) : triangle_locator(m, box_of_sites(m.sites)) {}

triangle_locator::triangle_locator(const mesh& m, const bounding_box& box)
    : places_(positions_of(m.sites)),
      triangles_(counter_clockwise(m)),
      links_(places_.size(), triangles_, mesh_links::lists::no_neighbours),
      box_(box),
      boxes_(box_) {
  for (vertex_index t = 0; t < triangles_.size(); ++t) {
    const triangle& c = triangles_[t];
    bounding_box around = box_of(places_[c[0]], places_[c[1]]);
    around.include(places_[c[2]]);
    boxes_.insert(t, around);
  }
}

// Doubles the search box around q until it holds triangles; the last box is thousands of times as
// wide as the mesh.
triangle_locator::located triangle_locator::deepest(const point& q) const {
  constexpr int most_doublings = 64;
  const double extent =
      std::max(box_.high.x / 2 - box_.low.x / 2, box_.high.y / 2 - box_.low.y / 2);
  located best;
  double depth = no_depth, half = 0;
  std::array<double, 3> weights{};
  for (int i = 0; i <= most_doublings && depth == no_depth; ++i) {
    best.reach = half;
    boxes_.visit({{q.x - half, q.y - half}, {q.x + half, q.y + half}}, [&](std::uint32_t t) {
      ++best.looked_at;
      const double here = find_weights(places_, triangles_[t], q, depth, weights);
      if (here > depth || (here == depth && t < best.triangle)) {
        best.triangle = t;
        best.weights = weights;
        depth = here;
      }
      return true;
    });
    half = half == 0 ? std::ldexp(extent, -50) : 2 * half;
  }
  if (depth == no_depth) best.weights = {1, 0, 0};
  return without_negative_weights(best);
}

triangle_locator::located triangle_locator::nearby(const point& q, vertex_index hint) const {
  // Tolerance of weights: their roundings are a few 1e-16 in a triangle that is not thin. Only the
  // choice between two neighbours depends on it, and both agree at their common edge.
  constexpr double slack = 1e-12;
  const std::size_t most = 64 + 4 * static_cast<std::size_t>(std::sqrt(triangles_.size()));
  located at;
  at.triangle = hint < triangles_.size() ? hint : 0;
  auto& w = at.weights;
  for (std::size_t step = 0; step < most; ++step) {
    if (find_weights(places_, triangles_[at.triangle], q, no_depth, w) >= -slack)
      return without_negative_weights(at);
    const std::size_t i = w[0] <= w[1] && w[0] <= w[2] ? 0 : w[1] <= w[2] ? 1 : 2;
    at.triangle = links_.across(at.triangle, i);
    if (at.triangle == no_triangle) break;
  }
  return deepest(q);
}

std::vector<graph_edge> triangle_locator::edges() const {
  std::vector<graph_edge> found;
  for (vertex_index t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (links_.across(t, i) > t)
        found.push_back({triangles_[t][(i + 1) % 3], triangles_[t][(i + 2) % 3]});
  return found;
}

}  // namespace asterism::internal
