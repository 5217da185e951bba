// SPDX-License-Identifier: MIT
//
// Stars at and across the boundary: corners, slits, touching rings, splits.
#include <catch2/catch.hpp>

#include "asterism/mesh/stars/consistency.hpp"
#include "asterism/mesh/stars/strictly_inside.hpp"
#include "asterism/mesh/stars/visibility.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// A square with a thin notch from above. Vertices 7 and 8 face each other across it.
domain notched() {
  domain d = polygon({{-1, -1}, {1, -1}, {1, 1}, {0.01, 1}, {0, -0.5}, {-0.01, 1}, {-1, 1}});
  d.vertices.push_back({-0.1, 0.5});
  d.vertices.push_back({0.1, 0.5});
  return d;
}

}  // namespace

TEST_CASE("the inside is exact, edges and vertices excluded") {
  const star_setting setting(square_with_hole());
  const auto inside = [&](double x, double y) {
    return strictly_inside(setting.edges, setting.sites, setting.kernel, {x, y});
  };
  CHECK(inside(0.5, 0.5));
  CHECK(inside(-0.5, -0.3));  // at the height of vertices of the hole
  CHECK_FALSE(inside(0, 0));
  CHECK_FALSE(inside(0.3, 0.3));
  CHECK_FALSE(inside(0.3, 0));
  CHECK_FALSE(inside(1, 0));
  CHECK_FALSE(inside(-1, -1));
  CHECK_FALSE(inside(-2, -1));
  CHECK_FALSE(inside(2, 0));
  CHECK(inside(std::nextafter(1.0, 0.0), 0));
  CHECK_FALSE(inside(std::nextafter(1.0, 2.0), 0));
}

TEST_CASE("sites see each other inside the domain only") {
  const star_setting setting(notched());
  const site_oracle oracle = setting.oracle();
  CHECK_FALSE(oracle.visible(7, 8));
  CHECK(oracle.visible(7, 0));
  CHECK(oracle.visible(7, 4));  // the tip of the notch
  CHECK_FALSE(oracle.visible(7, 2));
  CHECK(oracle.visible(8, 2));
}

TEST_CASE("a boundary vertex on the segment hides what is behind it") {
  domain d = polygon({{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}});
  d.vertices.push_back({-0.5, 0});
  d.vertices.push_back({0.5, 0});
  const star_setting setting(d);
  CHECK_FALSE(setting.oracle().visible(5, 6));
  CHECK(setting.oracle().visible(5, 3));
}

TEST_CASE("stars on the two sides of a slit do not know each other") {
  const star_setting setting(notched());
  star_set stars;
  stars.construct_all(setting.oracle());
  CHECK_FALSE(stars[7].contains(8));
  CHECK_FALSE(stars[8].contains(7));
  CHECK_FALSE(stars[7].contains(3));
  CHECK(check_consistency(setting.oracle(), stars).consistent());
}

TEST_CASE("where rings touch a vertex has a sector for each angle") {
  // Two triangles with a common corner.
  domain d;
  d.vertices = {{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  d.segments = {{0, 1, 1}, {1, 2, 1}, {2, 0, 1}, {0, 3, 1}, {3, 4, 1}, {4, 0, 1}};
  const star_setting setting(d);
  REQUIRE(setting.edges.corners(0).size() == 2);
  star_set stars;
  stars.construct_all(setting.oracle());
  const consistency_report report = check_consistency(setting.oracle(), stars);
  CHECK(report.consistent());
  CHECK(report.agreeing == std::vector<triangle>{{0, 1, 2}, {0, 3, 4}});
}

TEST_CASE("segments that do not separate inside from outside are refused") {
  domain d = square();
  std::swap(d.segments[2].a, d.segments[2].b);
  tier_counters decided;
  const auto built = boundary::build(d, star_predicates_on<filtered_kernel>(decided));
  REQUIRE_FALSE(built.ok());
  CHECK(built.failure().message.find("vertex 3") != std::string::npos);
}

TEST_CASE("splitting a piece renews the stars at its ends and keeps the chain") {
  star_setting setting(notched());
  star_set stars;
  stars.construct_all(setting.oracle());
  setting.sites.push_back({{0.25, -1}, {1, 0, 1}});
  setting.edges.split(0, 9);
  stars.split_subsegment(setting.oracle(), 0, 9, 1);
  CHECK(setting.edges.is_subsegment(0, 9));
  CHECK(setting.edges.is_subsegment(9, 1));
  CHECK_FALSE(setting.edges.is_subsegment(0, 1));
  CHECK(stars[0].sectors.at(0).neighbours.front() == 9);
  CHECK(stars[1].sectors.at(0).neighbours.back() == 9);
  for (vertex_index v = 0; v < stars.size(); ++v) stars.rebuild(setting.oracle(), v);
  CHECK(check_consistency(setting.oracle(), stars).consistent());
  const auto chain = setting.edges.in_order();
  REQUIRE(chain.size() == 8);
  CHECK(chain[0].b == 9);
  CHECK(chain[1].a == 9);
  CHECK(chain[1].segment == 0);
  CHECK(chain[2].segment == 1);
}

TEST_CASE("a split point rounded inwards hides what it cuts off") {
  // The vertices 4 and 5 are so near the lower side that a new vertex at (0, 0.02) separates them.
  domain d = polygon({{-1, 0}, {1, 0}, {1, 1}, {-1, 1}});
  d.vertices.push_back({-0.5, 0.0125});
  d.vertices.push_back({0.5, 0.0125});
  star_setting setting(d);
  star_set stars;
  stars.construct_all(setting.oracle());
  REQUIRE(stars[4].contains(5));
  setting.sites.push_back({{0, 0.02}, {1, 0, 1}});
  setting.edges.split(0, 6);
  stars.split_subsegment(setting.oracle(), 0, 6, 1);
  CHECK_FALSE(stars[4].contains(5));
  CHECK(stars[4].contains(6));
}
