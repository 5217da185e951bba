// SPDX-License-Identifier: MIT
#include "asterism/mesh/numerics/approximate_star.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace {

using namespace asterism;
using namespace asterism::internal;

point at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// A site in the middle of so many others on a circle, and its star.
struct wheel {
  std::vector<site> sites{{{0, 0}, {1, 0, 1}}};
  plain_star star;

  explicit wheel(std::size_t spokes, double turned) {
    for (std::size_t i = 0; i < spokes; ++i)
      sites.push_back({at(1, turned + 2 * std::numbers::pi * static_cast<double>(i) /
                                          static_cast<double>(spokes)),
                       {1, 0, 1}});
    std::vector<vertex_index> others(spokes);
    std::iota(others.begin(), others.end(), vertex_index{1});
    star = build_plain_star(sites, 0, others);
  }
};

// Holds the site against every gap: the one whose neighbours are nearest to its direction on both
// sides.
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

}  // namespace

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
