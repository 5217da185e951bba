// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/consistency.hpp"

#include <catch2/catch.hpp>

#include "asterism/mesh/stars/canonical_triangle.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// A square and its centre: four triangles round site 4.
domain pinwheel() {
  domain d = square();
  d.vertices.push_back({0.1, 0});
  return d;
}

std::vector<star> agreed_stars() {
  return {{{{{1, 4, 3}, false}}},
          {{{{2, 4, 0}, false}}},
          {{{{3, 4, 1}, false}}},
          {{{{0, 4, 2}, false}}},
          {{{{0, 1, 2, 3}, true}}}};
}

consistency_report check(std::vector<star> stars, const std::vector<vertex_index>& unsettled = {}) {
  const star_setting setting(pinwheel());
  return check_consistency(setting.oracle(), star_set(std::move(stars), unsettled));
}

bool has_defect(const consistency_report& report, defect_kind kind, vertex_index owner,
                vertex_index other) {
  return std::any_of(report.defects.begin(), report.defects.end(), [&](const defect& d) {
    return d.kind == kind && d.owner == owner && d.other == other;
  });
}

}  // namespace

TEST_CASE("stars that agree have no defect") {
  const consistency_report report = check(agreed_stars());
  CHECK(report.consistent());
  CHECK(report.disagreeing.empty());
  CHECK(report.agreeing == std::vector<triangle>{{0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {2, 3, 4}});
}

TEST_CASE("constructed stars of the same sites are those") {
  const star_setting setting(pinwheel());
  star_set stars;
  stars.construct_all(setting.oracle());
  CHECK(check_consistency(setting.oracle(), stars).agreeing.size() == 4);
  for (vertex_index v = 0; v < 4; ++v) CHECK(stars[v] == agreed_stars()[v]);
}

TEST_CASE("a missing edge is named, with the star that lacks it") {
  auto stars = agreed_stars();
  stars[0].sectors[0].neighbours = {1, 3};  // removes 4 from the star of 0
  const consistency_report report = check(stars);
  CHECK_FALSE(report.consistent());
  CHECK(has_defect(report, defect_kind::missing_edge, 4, 0));  // 4 - 0 is not in the star of 0
  CHECK(has_defect(report, defect_kind::missing_edge, 0, 1) == false);
  CHECK(has_defect(report, defect_kind::missing_triangle, 1, 0));  // the edge 1 - 0 is there
  CHECK(has_defect(report, defect_kind::missing_edge, 0, 4) == false);
  // {0, 1, 3} is in the star of 0 alone; 0-1-4 and 0-4-3 are in those of their other corners.
  CHECK(report.disagreeing == std::vector<triangle>{{0, 1, 3}, {0, 1, 4}, {0, 4, 3}});
  CHECK(report.agreeing == std::vector<triangle>{{1, 2, 4}, {2, 3, 4}});
}

TEST_CASE("a missing triangle is told from a missing edge") {
  auto stars = agreed_stars();
  // Removes 1: the star has 4, 0, 2, which is clockwise of the centre.
  stars[4].sectors[0].neighbours = {0, 2, 3};
  const consistency_report report = check(stars);
  CHECK(has_defect(report, defect_kind::missing_edge, 1, 4));
  CHECK(has_defect(report, defect_kind::missing_triangle, 0, 4));
  for (const defect& d : report.defects)
    if (d.kind == defect_kind::missing_triangle && d.owner == 0)
      CHECK(d.where == triangle{0, 1, 4});
}

TEST_CASE("a gap of 180 degrees or more is a defect of its star") {
  auto stars = agreed_stars();
  stars[4].sectors[0].neighbours = {0, 1};
  const consistency_report report = check(stars);
  CHECK(has_defect(report, defect_kind::wide_gap, 4, 4));
  stars[4].sectors[0].neighbours = {};
  CHECK(has_defect(check(stars), defect_kind::wide_gap, 4, 4));
  stars[4].sectors[0].neighbours = {2};
  CHECK(has_defect(check(stars), defect_kind::wide_gap, 4, 4));
}

TEST_CASE("a star that did not settle is a defect even where triangles agree") {
  const consistency_report report = check(agreed_stars(), {2});
  CHECK(report.disagreeing.empty());
  CHECK_FALSE(report.consistent());
  REQUIRE(report.defects.size() == 1);
  CHECK(report.defects[0].kind == defect_kind::unsettled);
  CHECK(report.defects[0].owner == 2);
}

TEST_CASE("canonical turns a triangle without turning it over") {
  CHECK(canonical({5, 2, 9}) == triangle{2, 9, 5});
  CHECK(canonical({2, 5, 9}) == triangle{2, 5, 9});
}
