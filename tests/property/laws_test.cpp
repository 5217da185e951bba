// SPDX-License-Identifier: MIT
//
// Laws of all predicates together: maps of the plane under which every answer stays. The laws of
// single predicates are in laws_pointwise_test.cpp and laws_arc_test.cpp.
#include <array>

#include "agreement.hpp"

namespace asterism::property {
namespace {

const exact_kernel exact;

// Four sites under a map that keeps every answer.
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
    four_sites turned = sites;  // by a right angle: (x, y) to (-y, x)
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
