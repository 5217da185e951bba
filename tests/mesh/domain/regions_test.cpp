// SPDX-License-Identifier: MIT
//
// Segments with the domain on both sides, what is open, and the numbers of regions.
#include <algorithm>
#include <string>
#include <tuple>

#include "asterism/mesh/domain/point_in_domain.hpp"
#include "fixtures/domain_kinds.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

std::string refusal(const domain& d) {
  const auto checked = check_domain(d);
  REQUIRE_FALSE(checked.ok());
  return checked.failure().message;
}

std::size_t internal_count(const domain& d) {
  return static_cast<std::size_t>(std::count_if(d.segments.begin(), d.segments.end(),
                                                [](const segment& s) { return s.internal; }));
}

// The square with a ring in it that has a gap.
domain with_open_ring() {
  domain d = polygon(box_ring(0, 0, 4, 4));
  add_chain(d, {{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1.25}});
  return d;
}

}  // namespace

TEST_CASE("what was accepted is accepted again, unchanged, whatever kind it is") {
  for (const named_domain& kind : domain_kinds()) {
    INFO(kind.name);
    domain_repairs repairs;
    const auto again = check_domain(kind.shape, &repairs);
    REQUIRE(again.ok());
    CHECK_FALSE(repairs.any());
    CHECK(again.value().vertices == kind.shape.vertices);
    REQUIRE(again.value().segments.size() == kind.shape.segments.size());
    for (std::size_t s = 0; s < kind.shape.segments.size(); ++s) {
      const segment &was = kind.shape.segments[s], &is = again.value().segments[s];
      CHECK(std::tuple(is.a, is.b, is.marker, is.internal, is.left_region, is.right_region) ==
            std::tuple(was.a, was.b, was.marker, was.internal, was.left_region, was.right_region));
    }
  }
}

TEST_CASE("segments with the domain on both sides are internal, the others are not") {
  CHECK(internal_count(with_diagonal()) == 1);
  CHECK(internal_count(with_dangling_segments()) == 3);
  CHECK(internal_count(island_in_hole()) == 0);
  CHECK(internal_count(touching_rings()) == 0);
  CHECK(internal_count(divided()) == 6 + 3);
}

TEST_CASE("a ring in a ring without a hole point divides the domain") {
  domain d = polygon(box_ring(0, 0, 4, 4));
  add_ring(d, box_ring(1, 1, 3, 3));
  const domain both = accepted(d);
  CHECK(internal_count(both) == 4);
  CHECK(contains(both, {2, 2}));
  CHECK(contains(both, {0.5, 0.5}));
  CHECK_FALSE(contains(both, {1, 2}));
  CHECK_FALSE(contains(both, {1, 1}));
}

TEST_CASE("rings of their own that share a side leave it between them") {
  domain d = polygon(box_ring(0, 0, 1, 1));
  add_ring(d, box_ring(1, 0, 2, 1));
  domain_repairs repairs;
  const auto checked = check_domain(d, &repairs);
  REQUIRE(checked.ok());
  CHECK(repairs.repeated_subsegments == 1);
  CHECK(internal_count(checked.value()) == 1);
}

TEST_CASE("a chain may end alone inside the domain, not outside and not in a hole") {
  domain d = with_open_ring();
  CHECK(internal_count(accepted(d)) == 4);
  d.holes = {{2, 2}};
  CHECK(refusal(d) ==
        "the boundary is not closed: it ends at vertex 5 (1, 1), the end of segment 5 (vertices "
        "5-6) alone, and at vertex 9 (1, 1.25), the end of segment 8 (vertices 8-9) alone");
  domain sticking_out = square();
  add_chain(sticking_out, {{1, 0}, {2, 0}});
  CHECK(refusal(sticking_out) ==
        "square: the boundary is not closed: it ends at vertex 6 (2, 0), the end of segment 5 "
        "(vertices "
        "5-6) alone, and comes from vertex 5 (1, 0)");
  domain beside = square();
  add_chain(beside, {{2, 0}, {3, 0}});
  CHECK_THAT(refusal(beside),
             Catch::Contains("at vertex 5 (2, 0)") && Catch::Contains("at vertex 6 (3, 0)"));
}

TEST_CASE("a hole point in a ring that is open to the outside: the ring is blamed") {
  domain d = polygon(box_ring(0, 0, 4, 4));
  d.segments.pop_back();
  d.holes = {{2, 2}};
  CHECK_THAT(refusal(d), Catch::StartsWith("the boundary is not closed"));
}

TEST_CASE("a spike, traced there and back, is dropped outside and kept inside") {
  domain d = polygon({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}});
  domain_repairs repairs;
  const auto outwards = check_domain(d, &repairs);
  REQUIRE(outwards.ok());
  CHECK(repairs.repeated_subsegments == 1);
  CHECK(repairs.outer_subsegments == 1);
  CHECK(internal_count(outwards.value()) == 0);
  d.vertices[4] = {2, 2};
  CHECK(internal_count(accepted(d)) == 1);
}

TEST_CASE("crossing segments inside the domain are refused like any others") {
  domain d = square();
  d.segments.push_back({0, 2, 0});
  d.segments.push_back({1, 3, 0});
  CHECK(refusal(d) == "square: segment 6 (vertices 2-4) crosses segment 5 (vertices 1-3)");
}

TEST_CASE("regions get the numbers of the points in them") {
  const domain d = divided();
  const auto regions_beside = [&](const point& a, const point& b) {
    for (const segment& s : d.segments) {
      if (d.vertices[s.a] == a && d.vertices[s.b] == b)
        return std::pair{s.left_region, s.right_region};
      if (d.vertices[s.a] == b && d.vertices[s.b] == a)
        return std::pair{s.right_region, s.left_region};
    }
    FAIL("no such segment");
    return std::pair{0, 0};
  };
  CHECK(regions_beside({1, 1}, {3, 1}) == std::pair{7, 0});
  CHECK(regions_beside({1, 2}, {3, 2}) == std::pair{-3, 7});
  CHECK(regions_beside({0.5, 2}, {1, 2}) == std::pair{0, 0});
  CHECK(regions_beside({0, 0}, {4, 0}).first == 0);
}

TEST_CASE("all regions numbered: what has no point gets the least numbers left") {
  domain d = divided();
  d.regions = {{{2, 2.5}, 1}};
  d.number_all_regions = true;
  d = accepted(d);
  std::vector<int> seen;
  for (const segment& s : d.segments) {
    seen.push_back(s.left_region);
    if (s.internal) seen.push_back(s.right_region);
  }
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  CHECK(seen == std::vector<int>{1, 2, 3});
  CHECK(d.segments[0].left_region == 2);  // the face of the first segment
}

TEST_CASE("without region points all is region 1") {
  for (const segment& s : with_diagonal().segments) {
    CHECK(s.left_region == 1);
    CHECK(s.right_region == 1);
  }
}

TEST_CASE("region points that mean nothing are refused by name") {
  domain d = polygon(box_ring(0, 0, 4, 4));
  add_ring(d, box_ring(1, 1, 3, 3));
  d.holes = {{2, 2}};
  d.regions = {{{0.5, 0.5}, 1}, {{2, 1.5}, 2}};
  CHECK(refusal(d) == "region 2 (2, 1.5) lies in a hole");
  d.regions[1].at = {5, 5};
  CHECK(refusal(d) == "region 2 (5, 5) lies outside of the domain");
  d.regions[1].at = {1, 2};
  CHECK(refusal(d) == "region 2 (1, 2) lies on segment 8 (vertices 8-5)");
  d.regions[1].at = {3.5, 3.5};
  CHECK(refusal(d) ==
        "region 2 (3.5, 3.5) and region 1 (0.5, 0.5) give different numbers to one region");
  d.regions[1].number = 1;
  accepted(d);
  d.regions[1].at.x = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(d) == "region 2 (nan, 3.5) is not finite");
}
