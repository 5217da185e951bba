// SPDX-License-Identifier: MIT
//
// Compares shortest and median distances from local searches with those over all pairs: the same
// doubles.
#include "asterism/mesh/stars/nearest_distances.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "asterism/mesh/numerics/constructions.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;
using asterism::vertex_index;
using asterism::test::splitmix64;

namespace {

double to_segment(const site& s, const point& a, const point& b) {
  const point d{b.x - a.x, b.y - a.y}, e{s.position.x - a.x, s.position.y - a.y};
  const double t =
      std::clamp(inner_product(s.metric, d, e) / squared_length(s.metric, d), 0.0, 1.0);
  return squared_distance(s, {a.x + t * d.x, a.y + t * d.y});
}

double shortest_of_all(const std::vector<site>& sites, vertex_index count, const boundary& edges,
                       double most) {
  double least = most * most;
  for (vertex_index v = 0; v < count; ++v) {
    for (vertex_index w = 0; w < sites.size(); ++w)
      if (w != v) least = std::min(least, squared_distance(sites[v], sites[w].position));
    for (const boundary_edge& p : edges.subsegments())
      if (p.a != v && p.b != v)
        least = std::min(least, to_segment(sites[v], sites[p.a].position, sites[p.b].position));
  }
  return std::sqrt(least);
}

double median_of_all(const std::vector<site>& sites, double most) {
  std::vector<double> nearest(sites.size(), most * most);
  for (vertex_index v = 0; v < sites.size(); ++v)
    for (vertex_index w = 0; w < sites.size(); ++w)
      if (v != w) {
        const double d = squared_distance(sites[v], sites[w].position);
        nearest[v] = std::min(nearest[v], d);
        nearest[w] = std::min(nearest[w], d);
      }
  std::sort(nearest.begin(), nearest.end());
  return std::sqrt(nearest[nearest.size() / 2]);
}

metric_tensor random_tensor(splitmix64& random, double condition, double unit) {
  const double t = random.real(0, 3.2), c = std::cos(t), s = std::sin(t);
  const double large = std::exp(random.real(0, std::log(condition)));
  return {(large * c * c + s * s) / (unit * unit), (large - 1) * c * s / (unit * unit),
          (large * s * s + c * c) / (unit * unit)};
}

struct scene {
  std::string name;
  domain shape;
};

std::vector<scene> scenes() {
  splitmix64 random(31);
  std::vector<scene> made = {{"square", square()}, {"hole", square_with_hole()}};
  domain scattered = square(), crowded = square(), grid = square();
  for (int i = 0; i < 300; ++i) {
    const double x = random.real(-0.9, 0.9), y = random.real(-0.9, 0.9);
    scattered.vertices.push_back({x, y});
    // Two thirds of the sites are within a millionth of the middle.
    const double near = i % 3 == 0 ? 1 : 0x1p-20;
    crowded.vertices.push_back({near * x, near * y});
    grid.vertices.push_back({(i % 17 - 8) / 10.0, (i / 17 - 8) / 10.0});
  }
  made.push_back({"scattered", scattered});
  made.push_back({"crowded", crowded});
  made.push_back({"grid", grid});
  std::vector<point> ring;
  for (int i = 0; i < 200; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.9, t = 2 * 3.14159265 * i / 200;
    ring.push_back({r * std::cos(t), r * std::sin(t)});
  }
  made.push_back({"saw", polygon(ring)});
  return made;
}

}  // namespace

TEST_CASE("given distances are those of all pairs, bit for bit") {
  for (const scene& now : scenes())
    for (const double scale : {1.0, 0x1p-300, 0x1p300})
      for (const double condition : {1.0, 1e3, 1e12})
        for (const bool varied : {false, true}) {
          INFO(now.name << ", scale " << scale << ", condition " << condition);
          splitmix64 random(32);
          const metric_tensor same = random_tensor(random, condition, scale);
          std::vector<site> sites;
          for (const point& q : now.shape.vertices)
            sites.push_back({{scale * q.x, scale * q.y},
                             varied ? random_tensor(random, condition, scale) : same});
          tier_counters decided;
          const star_predicates_on<filtered_kernel> kernel(decided);
          const boundary edges = boundary::build(now.shape, kernel).value();
          const proximity near(sites, edges);
          for (const double most : {std::numeric_limits<double>::infinity(), 1.0, 1e-3}) {
            for (const std::size_t count : {sites.size(), sites.size() / 3})
              CHECK(shortest_distance(sites, static_cast<vertex_index>(count), edges, near, most) ==
                    shortest_of_all(sites, static_cast<vertex_index>(count), edges, most));
            CHECK(median_distance(sites, near, most) == median_of_all(sites, most));
          }
        }
}

TEST_CASE("given distances of one site and of none") {
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  const std::vector<site> one = {{{0.5, 0.5}, {1, 0, 1}}};
  const proximity near(one, boundary());
  CHECK(shortest_distance(one, 1, boundary(), near, 2) == 2);
  CHECK(median_distance(one, near, 2) == 2);
  CHECK(std::isinf(median_distance(one, near, INFINITY)));
  CHECK(shortest_distance({}, 0, boundary(), proximity({}, boundary()), 2) == 2);
}
