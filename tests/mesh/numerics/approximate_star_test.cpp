// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/approximate_star.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "asterism/core/random.hpp"

namespace {

using namespace asterism;
using namespace asterism::internal;

point at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Holds a site surrounded by others on a circle, and its star.
struct wheel {
  std::vector<site> sites{{{0, 0}, {1, 0, 1}}};
  approximate_star star;

  explicit wheel(std::size_t spokes, double turned) {
    for (std::size_t i = 0; i < spokes; ++i)
      sites.push_back({at(1, turned + 2 * std::numbers::pi * static_cast<double>(i) /
                                          static_cast<double>(spokes)),
                       {1, 0, 1}});
    std::vector<vertex_index> others(spokes);
    std::iota(others.begin(), others.end(), vertex_index{1});
    star = build_approximate_star(sites, 0, others);
  }
};

// True if q is nearer than the gap's sites to the Voronoi vertex of the gap that contains q's
// direction.
bool is_nearer_to_a_vertex(const wheel& w, const point& q) {
  for (std::size_t i = 0; i < w.star.size(); ++i) {
    const point &y = w.sites[w.star[i].neighbour].position,
                &x = w.sites[w.star[following(w.star, i)].neighbour].position;
    if (y.x * q.y - y.y * q.x < 0 || q.x * x.y - q.y * x.x <= 0) continue;
    const point& vertex = w.star[i].vertex;
    const double dx = vertex.x - q.x, dy = vertex.y - q.y;
    return dx * dx + dy * dy < w.star[i].squared_radius;
  }
  return false;
}

// Returns sites on a grid, moved slightly, in a metric that rotates and stretches.
std::vector<site> sites_in_turning_metric(int n) {
  splitmix64 random(5);
  std::vector<site> sites;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const point q{i + random.real(-0.2, 0.2), j + random.real(-0.2, 0.2)};
      const double angle = 0.15 * (q.x + q.y), s = std::sin(angle), c = std::cos(angle);
      const double one = 1, other = 1 + 0.1 * q.x;
      sites.push_back(
          {q, {one * c * c + other * s * s, (one - other) * c * s, one * s * s + other * c * c}});
    }
  return sites;
}

std::vector<vertex_index> sites_near(const std::vector<site>& sites, vertex_index v) {
  std::vector<vertex_index> near;
  for (vertex_index w = 0; w < sites.size(); ++w) {
    const double dx = sites[w].position.x - sites[v].position.x,
                 dy = sites[w].position.y - sites[v].position.y;
    if (w != v && dx * dx + dy * dy < 6.25) near.push_back(w);
  }
  return near;
}

// Returns how many triangles in the stars of inner sites are missing in the star of another corner.
template <class Build>
std::size_t disagreeing(const std::vector<site>& sites, int n, const Build& build) {
  std::vector<std::vector<vertex_index>> stars(sites.size());
  for (vertex_index v = 0; v < sites.size(); ++v)
    for (const approximate_gap& gap : build(v, sites_near(sites, v)))
      stars[v].push_back(gap.neighbour);
  const auto has = [&](vertex_index v, vertex_index y, vertex_index x) {
    const auto at = std::find(stars[v].begin(), stars[v].end(), y);
    return at != stars[v].end() && (at + 1 == stars[v].end() ? stars[v][0] : at[1]) == x;
  };
  std::size_t found = 0;
  for (int j = 2; j + 2 < n; ++j)
    for (int i = 2; i + 2 < n; ++i) {
      const auto v = static_cast<vertex_index>(i + j * n);
      for (std::size_t k = 0; k < stars[v].size(); ++k) {
        const vertex_index y = stars[v][k], x = stars[v][(k + 1) % stars[v].size()];
        if (!has(y, x, v) || !has(x, v, y)) ++found;
      }
    }
  return found;
}

}  // namespace

TEST_CASE("careful stars agree where those of the hull do not", "[star]") {
  constexpr int n = 20;
  const std::vector<site> sites = sites_in_turning_metric(n);
  const std::size_t by_hull = disagreeing(sites, n, [&](vertex_index v, const auto& near) {
    return build_approximate_star(sites, v, near);
  });
  const std::size_t with_care = disagreeing(sites, n, [&](vertex_index v, const auto& near) {
    return build_careful_star(sites, v, near);
  });
  CHECK(by_hull > 40);
  CHECK(with_care <= by_hull / 10);
}

TEST_CASE("of sites on one ray a careful star has the nearest alone", "[star]") {
  // Metrics vary, so that farther sites of the ray are on the hull too.
  std::vector<site> sites{{{0, 0}, {1, 0, 1}}, {{1, 2}, {1, 0, 1}}, {{-1, 2}, {1, 0, 1}}};
  for (int i = 1; i < 6; ++i) {
    sites.push_back({{static_cast<double>(i), 0}, {1.0 / i, -0.3 / i, 1.0 / i}});
    sites.push_back({{-static_cast<double>(i), 0}, {1.0 / i, 0.3 / i, 1.0 / i}});
  }
  std::vector<vertex_index> others(sites.size() - 1);
  std::iota(others.begin(), others.end(), vertex_index{1});
  const auto on_line = [&](const approximate_star& star) {
    return std::count_if(star.begin(), star.end(), [&](const approximate_gap& gap) {
      return sites[gap.neighbour].position.y == 0;
    });
  };
  CHECK(on_line(build_approximate_star(sites, 0, others)) > 2);
  CHECK(on_line(build_careful_star(sites, 0, others)) == 2);
}

TEST_CASE("a star is plain where doubles leave no doubt, and not where four sites are on a circle",
          "[star]") {
  const wheel even(6, 0.1);
  CHECK(is_plainly_a_star(even.sites, 0, even.star));
  const std::vector<site> grid{{{0, 0}, {1, 0, 1}},  {{1, 0}, {1, 0, 1}},  {{1, 1}, {1, 0, 1}},
                               {{0, 1}, {1, 0, 1}},  {{-1, 0}, {1, 0, 1}}, {{0, -1}, {1, 0, 1}},
                               {{-1, -1}, {1, 0, 1}}};
  approximate_star on_circle = build_approximate_star(grid, 0, {1, 3, 4, 5});
  CHECK(is_plainly_a_star(grid, 0, on_circle));
  // (1, 1) is on the circle around (0, 0), (1, 0) and (0, 1).
  on_circle.insert(std::find_if(on_circle.begin(), on_circle.end(),
                                [](const approximate_gap& g) { return g.neighbour == 3; }),
                   approximate_gap{2, {}, 0});
  for (std::size_t i = 0; i < on_circle.size(); ++i)
    close_gap(grid, 0, on_circle[i], on_circle[following(on_circle, i)].neighbour);
  CHECK_FALSE(is_plainly_a_star(grid, 0, on_circle));
}

TEST_CASE("a star of hundreds finds the gap that a site lies in as one of few does", "[star]") {
  for (const std::size_t spokes : {7u, 17u, 100u, 301u})
    for (const double turned : {0.0, 0.4, 3.0}) {
      wheel w(spokes, turned);
      REQUIRE(w.star.size() == spokes);
      w.sites.push_back({});
      const auto last = static_cast<vertex_index>(w.sites.size() - 1);
      for (int k = 0; k < 500; ++k) {
        const double angle = 0.001 + 0.01257 * k, radius = 0.9 + 0.0004 * k;
        w.sites[last] = {at(radius, angle), {1, 0, 1}};
        INFO(spokes << " spokes, turned by " << turned << ", at " << angle);
        CHECK(disturbs(w.sites, 0, w.star, last) ==
              is_nearer_to_a_vertex(w, w.sites[last].position));
      }
    }
}
