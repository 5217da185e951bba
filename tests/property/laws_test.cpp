// SPDX-License-Identifier: MIT
//
// Laws the answers obey whatever the arithmetic: symmetry, invariance, agreement among predicates.
// No oracle here, so many more cases.
#include <array>

#include "agreement.hpp"

namespace asterism::property {
namespace {

const exact_kernel exact;

TEST_CASE("orientation changes sign with every exchange", "[property][laws]") {
  random_source random(21);
  for (int i = 0; i < 20000; ++i) {
    const double unit = random.chance(2) ? 1 : 0.1;
    const std::array<point, 3> points = {
        point{unit * random.integer(-9, 9), unit * random.integer(-9, 9)},
        point{unit * random.integer(-9, 9), unit * random.integer(-9, 9)},
        point{unit * random.integer(-9, 9), unit * random.integer(-9, 9)}};
    const auto& [p, q, r] = points;
    const sign s = exact.orientation(p, q, r);
    const std::string replay = record("orientation", {}, points);
    expect_equal(s, exact.orientation(q, r, p), replay, "turned");
    expect_equal(-s, exact.orientation(q, p, r), replay, "exchanged");
    expect_equal(-s, exact.orientation(p, r, q), replay, "exchanged");
  }
}

TEST_CASE("pairs: exchanging the sites", "[property][laws]") {
  for_each_case(500, [](const four_sites& sites, random_source& random) {
    const auto& [v, w, x, y] = sites;
    const std::array<point, 1> points = {draw_point(sites, random)};
    const point& p = points[0];
    const std::string replay = record("dominates", {sites.data(), 2}, points);
    expect_equal(exact.compare_distance(v, w, p), -exact.compare_distance(w, v, p), replay,
                 "compare_distance");
    expect_equal(exact.in_wedge(v, w, p), exact.in_wedge(w, v, p), replay, "in_wedge");
    expect_equal(exact.dominates(v, w, p), -exact.dominates(w, v, p), replay, "dominates");
    expect_equal(sign::positive, exact.dominates(v, w, v.position), replay, "at its own site");
    expect_equal(exact.encroaches(v, w, x), exact.encroaches(w, v, x),
                 record("encroaches", {sites.data(), 3}), "encroaches");
  });
}

TEST_CASE("counts: any order of the sites, and each other", "[property][laws]") {
  for_each_case(150, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, y] = sites;
    const std::string replay = record("voronoi_vertex_count", {sites.data(), 3});
    const int vertices = exact.voronoi_vertex_count(v, w, x);
    expect_equal(vertices, exact.voronoi_vertex_count(v, x, w), replay, "vxw");
    expect_equal(vertices, exact.voronoi_vertex_count(w, v, x), replay, "wvx");
    expect_equal(vertices, exact.voronoi_vertex_count(x, w, v), replay, "xwv");
    const int on_arc = exact.arc_intersection_count(v, w, x);
    expect_equal(on_arc, exact.arc_intersection_count(w, v, x), replay, "arc of w, v");
    expect(vertices == -1 || (0 <= on_arc && on_arc <= vertices && vertices <= 4), replay,
           "finitely many vertices bound the count on the arc");
    expect(vertices >= -1 && vertices <= 4 && on_arc >= -1 && on_arc <= 4, replay, "range");
  });
}

TEST_CASE("insertion and edge tests: both symmetries, and a raw yes stays yes",
          "[property][laws]") {
  for_each_case(150, [](const four_sites& sites, random_source&) {
    const auto& [v, w, x, y] = sites;
    const std::string replay = record("insertion_test", sites);
    const bool raw = exact.insertion_test(v, w, x, y);
    expect_equal(raw, exact.insertion_test(w, v, x, y), replay, "insertion_test(w, v, x, y)");
    expect_equal(raw, exact.insertion_test(v, w, y, x), replay, "insertion_test(v, w, y, x)");
    const bool decided = exact.edge_test(v, w, x, y);
    expect_equal(decided, exact.edge_test(w, v, x, y), replay, "edge_test(w, v, x, y)");
    expect_equal(decided, exact.edge_test(v, w, y, x), replay, "edge_test(v, w, y, x)");
    expect(decided || !raw, replay, "edge_test no where insertion_test is yes");
  });
}

// Four sites seen through a map that keeps every answer.
void expect_same_answers(const four_sites& before, const four_sites& after, const char* what) {
  const auto& [v, w, x, y] = before;
  const auto& [v2, w2, x2, y2] = after;
  const std::string replay = record("insertion_test", before);
  const std::string who = what;
  const filtered_kernel filtered;
  expect_equal(exact.insertion_test(v, w, x, y), exact.insertion_test(v2, w2, x2, y2), replay,
               who + ", exact insertion_test");
  expect_equal(exact.insertion_test(v, w, x, y), filtered.insertion_test(v2, w2, x2, y2), replay,
               who + ", filtered insertion_test");
  expect_equal(exact.edge_test(v, w, x, y), exact.edge_test(v2, w2, x2, y2), replay,
               who + ", edge_test");
  expect_equal(exact.voronoi_vertex_count(v, w, x), exact.voronoi_vertex_count(v2, w2, x2), replay,
               who + ", voronoi_vertex_count");
  expect_equal(exact.arc_intersection_count(v, w, x), exact.arc_intersection_count(v2, w2, x2),
               replay, who + ", arc_intersection_count");
  expect_equal(exact.encroaches(v, w, x), exact.encroaches(v2, w2, x2), replay,
               who + ", encroaches");
}

TEST_CASE("scaling by powers of two changes nothing", "[property][laws]") {
  for_each_case(30, [](const four_sites& sites, random_source& random) {
    const int sign_of_exponent = random.chance(2) ? 1 : -1;
    const int coordinates = 400 * sign_of_exponent, metrics = random.integer(-400, 400);
    four_sites after = sites;
    for (site& s : after) s = scaled(s, coordinates, metrics);
    expect_same_answers(sites, after, "scaled");
  });
}

TEST_CASE("exact translations change nothing", "[property][laws]") {
  for (const char* name : {"small integers", "common point", "shared line", "crossing line pairs",
                           "cocircular", "mirror images"}) {
    random_source random(31);
    for (int i = 0; i < 40; ++i) {
      const four_sites sites = draw(kind_named(name), random);
      four_sites after = sites;
      for (site& s : after) {
        s.position.x += 0x1p40;
        s.position.y -= 0x1p39;
      }
      expect_same_answers(sites, after, "translated");
    }
  }
}

TEST_CASE("a tie-free answer does not depend on the frame", "[property][laws]") {
  for_each_case(60, [](const four_sites& sites, random_source&) {
    four_sites turned = sites;  // by a quarter: (x, y) to (-y, x)
    for (site& s : turned) {
      s.position = {-s.position.y, s.position.x};
      s.metric = {s.metric.m22, -s.metric.m12, s.metric.m11};
    }
    const std::string replay = record("insertion_test", sites);
    expect_equal(exact.insertion_test(sites[0], sites[1], sites[2], sites[3]),
                 exact.insertion_test(turned[0], turned[1], turned[2], turned[3]), replay,
                 "turned by a quarter");
  });
}

}  // namespace
}  // namespace asterism::property
