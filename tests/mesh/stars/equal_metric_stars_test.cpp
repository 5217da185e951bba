// SPDX-License-Identifier: MIT
//
// Compares stars made all at once in one metric with stars made one at a time from all sites.
#include "asterism/mesh/stars/equal_metric_stars.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "asterism/mesh/stars/consistency.hpp"
#include "asterism/mesh/stars/delaunay_triangulation.hpp"
#include "asterism/mesh/stars/star_finality.hpp"
#include "asterism/mesh/stars/star_set.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;
using asterism::vertex_index;
using asterism::test::splitmix64;

namespace {

void scatter(domain& d, int count, double half, std::uint64_t seed) {
  splitmix64 random(seed);
  for (int i = 0; i < count; ++i) {
    const double x = random.real(-half, half), y = random.real(-half, half);
    d.vertices.push_back({x, y});
  }
}

void add_grid(domain& d, int side) {
  for (int i = 1; i < side; ++i)
    for (int j = 1; j < side; ++j) d.vertices.push_back({-1 + 2.0 * i / side, -1 + 2.0 * j / side});
}

// The square with segments inside that cross many edges of the triangulation without them: one from
// side to side, one that begins in its middle and ends inside, and one apart.
domain divided_square() {
  domain d = square();
  d.vertices.insert(
      d.vertices.end(),
      {{-1, 0.0625}, {1, 0.125}, {0.25, 0.1015625}, {0.5, 0.875}, {-0.75, -0.75}, {0.75, -0.5}});
  d.segments.push_back({4, 6, 2});
  d.segments.push_back({6, 5, 2});
  d.segments.push_back({6, 7, 3});
  d.segments.push_back({8, 9, 4});
  return d;
}

domain moved(domain d, double scale, const point& offset) {
  for (point& q : d.vertices) q = {offset.x + scale * q.x, offset.y + scale * q.y};
  return d;
}

struct arrangement {
  std::string name;
  domain shape;
};

std::vector<arrangement> arrangements() {
  std::vector<arrangement> all;
  const auto add = [&](const std::string& name, const domain& d) { all.push_back({name, d}); };
  for (const named_domain& each : domain_kinds()) add(each.name, each.shape);
  domain random = square(), grid = square(), cluster = square(), hole = square_with_hole(),
         divided = divided_square();
  scatter(random, 60, 0.99, 1);
  add_grid(grid, 8);
  scatter(cluster, 20, 0.99, 2);
  scatter(cluster, 20, 1e-9, 3);
  for (const point& q : {point{0.5, 0.5}, {-0.5, 0.5}, {0.6, -0.7}, {0, 0.9}, {-0.9, -0.8}})
    hole.vertices.push_back(q);
  scatter(divided, 60, 0.99, 4);
  add("random", random);
  add("grid", grid);
  add("cluster", cluster);
  add("hole", hole);
  add("divided", divided);
  add("far", moved(random, 1, {1e8, -1e8}));
  add("small", moved(random, 0x1p-300, {}));
  add("large", moved(divided, 0x1p300, {}));
  return all;
}

// Returns the star with each closed sector rotated so that it begins with the least neighbour.
star in_order(star s) {
  for (sector& part : s.sectors)
    if (part.closed)
      std::rotate(part.neighbours.begin(),
                  std::min_element(part.neighbours.begin(), part.neighbours.end()),
                  part.neighbours.end());
  return s;
}

}  // namespace

TEST_CASE("stars made all at once in one metric are those made one by one from all sites") {
  const std::vector<metric_tensor> metrics = {
      {1, 0, 1}, {4, 1, 9}, {1e8, 9e3, 1}, {1, 0.5, 0.2501}};
  for (const arrangement& a : arrangements())
    for (const metric_tensor& metric : metrics) {
      INFO(a.name << ", metric " << metric.m11 << " " << metric.m12 << " " << metric.m22);
      const indexed_setting now(accepted(a.shape), constant_field(metric));
      const auto made = stars_of_equal_metrics(now.oracle(), {});
      REQUIRE(made);
      REQUIRE(made->size() == now.sites.size());
      for (vertex_index v = 0; v < now.sites.size(); ++v) {
        INFO("star of site " << v);
        const constructed_star alone = construct_star(now.of_all(), v);
        REQUIRE(alone.settled);
        CHECK((*made)[v].settled);
        CHECK(in_order((*made)[v].content) == in_order(alone.content));
        // Both reaches are upper bounds of the same radius. The gap's reach has the greater margin.
        const auto reach = final_reach(now.oracle(), v, (*made)[v].content);
        REQUIRE(reach);
        REQUIRE((*made)[v].final_reach);
        CHECK(*(*made)[v].final_reach <= *reach * (1 + 1e-9));
        const double radius = farthest_vertex(now.oracle(), v, (*made)[v].content);
        // Doubles have a larger error where the metric is thin, and may find no vertex that is far
        // away.
        if (std::isfinite(radius)) CHECK(*(*made)[v].final_reach >= radius * (1 - 1e-2));
      }
    }
}

TEST_CASE("triangles made all at once in one metric are those of the stars") {
  for (const arrangement& a : arrangements())
    for (const metric_tensor& metric : {metric_tensor{1, 0, 1}, metric_tensor{4, 1, 9}}) {
      INFO(a.name << ", metric " << metric.m11 << " " << metric.m12 << " " << metric.m22);
      const indexed_setting now(accepted(a.shape), constant_field(metric));
      star_set stars;
      stars.construct_all(now.oracle());
      REQUIRE(check_consistency(now.oracle(), stars).consistent());
      for (const auto by : {star_confirmation::by_mesher, star_confirmation::by_auditor}) {
        const auto made = triangles_of_equal_metrics(now.oracle(), {}, by);
        REQUIRE(made);
        CHECK(*made == triangles_of_consistent(stars));
      }
    }
}

TEST_CASE("stars are not made all at once where metrics differ, or sites coincide") {
  domain d = square();
  scatter(d, 10, 0.9, 7);
  indexed_setting now(accepted(d), identity_field());
  REQUIRE(stars_of_equal_metrics(now.oracle(), {}));
  REQUIRE(triangles_of_equal_metrics(now.oracle(), {}, star_confirmation::by_auditor));
  now.sites[9].metric.m11 = 1 + 0x1p-52;
  CHECK_FALSE(stars_of_equal_metrics(now.oracle(), {}));
  CHECK_FALSE(triangles_of_equal_metrics(now.oracle(), {}, star_confirmation::by_auditor));
  now.sites[9] = now.sites[8];
  CHECK_FALSE(stars_of_equal_metrics(now.oracle(), {}));
  CHECK_FALSE(triangles_of_equal_metrics(now.oracle(), {}, star_confirmation::by_auditor));
}

TEST_CASE("a net refuses a segment through a site, and one across another") {
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  const metric_tensor one{1, 0, 1};
  const std::vector<site> sites = {
      {{0, 0}, one}, {{2, 0}, one}, {{1, 0}, one}, {{1, 3}, one}, {{1.5, -2}, one}};
  const auto with_sites = [&] {
    delaunay_triangulation delaunay(sites, kernel);
    for (vertex_index v = 0; v < sites.size(); ++v) REQUIRE(delaunay.insert(v));
    return delaunay;
  };
  delaunay_triangulation through = with_sites();
  CHECK_FALSE(through.insert_segment(0, 1));
  delaunay_triangulation across = with_sites();
  REQUIRE(across.insert_segment(3, 4));
  REQUIRE(across.settle());
  CHECK_FALSE(across.insert_segment(2, 1));
  delaunay_triangulation twice = with_sites();
  CHECK_FALSE(twice.insert(2));
}

TEST_CASE(
    "sites put into a triangulation that is done leave it sound, and segments where they are") {
  const domain d = accepted(divided_square());
  star_setting now(d);
  tier_counters decided;
  const star_predicates_on<filtered_kernel> kernel(decided);
  delaunay_triangulation delaunay(now.sites, kernel);
  for (vertex_index v = 0; v < now.sites.size(); ++v) REQUIRE(delaunay.insert(v));
  for (const boundary_edge& e : now.edges.subsegments()) REQUIRE(delaunay.insert_segment(e.a, e.b));
  REQUIRE(delaunay.settle());
  const auto is_better = [&](vertex_index a, vertex_index b, vertex_index x, vertex_index y) {
    const auto& all = delaunay.all_sites();
    return !kernel.edge_test(all[a], all[b], all[x], all[y]);
  };
  std::uint32_t at = delaunay.find_edge(0, 1).value().face;
  std::size_t added = 0;
  for (int i = 1; i < 16; ++i)
    for (int j = 1; j < 16; ++j) {
      const point q{-1 + i / 8.0, -1 + j / 8.0};  // some are on edges, one is on a segment
      const auto found = delaunay.locate_near(q, at);
      if (!found) continue;  // beyond a segment, or at a site
      at = delaunay.at(delaunay.insert_towards({q, {1, 0, 1}}, *found, is_better, 1000)).face;
      ++added;
    }
  CHECK(added > 40);
  for (std::uint32_t f = 0; f < delaunay.faces().size(); ++f) CHECK(delaunay.is_sound(f, kernel));
  for (const boundary_edge& e : now.edges.subsegments()) {
    const auto left = delaunay.find_edge(e.a, e.b);
    REQUIRE(left);
    CHECK(delaunay.faces()[left->face].fixed[left->corner]);
  }
}
