// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/check_domain.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

void add_ring(domain& d, const std::vector<point>& ring, int marker = 0) {
  const auto first = static_cast<vertex_index>(d.vertices.size());
  const auto size = static_cast<vertex_index>(ring.size());
  d.vertices.insert(d.vertices.end(), ring.begin(), ring.end());
  for (vertex_index i = 0; i < size; ++i)
    d.segments.push_back({first + i, first + (i + 1) % size, marker});
}

std::vector<point> box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

domain rings(const std::vector<std::vector<point>>& all, const std::vector<point>& holes = {}) {
  domain d;
  d.name = "test";
  for (const auto& ring : all) add_ring(d, ring);
  d.holes = holes;
  return d;
}

// Returns twice the signed area that the segments enclose on their left.
double doubled_area(const domain& d) {
  double sum = 0;
  for (const segment& s : d.segments)
    sum += d.vertices[s.a].x * d.vertices[s.b].y - d.vertices[s.b].x * d.vertices[s.a].y;
  return sum;
}

domain accepted(const domain& d, domain_repairs* repairs = nullptr) {
  const auto checked = check_domain(d, repairs);
  INFO((checked.ok() ? "" : checked.failure().message));
  REQUIRE(checked.ok());
  domain_repairs second;
  const auto again = check_domain(checked.value(), &second);
  REQUIRE(again.ok());
  REQUIRE_FALSE(second.any());
  REQUIRE(again.value().vertices == checked.value().vertices);
  REQUIRE(again.value().segments.size() == checked.value().segments.size());
  return checked.value();
}

std::string refusal(const domain& d) {
  const auto checked = check_domain(d);
  REQUIRE_FALSE(checked.ok());
  CHECK(checked.failure().code == error_code::invalid_domain);
  return checked.failure().message;
}

}  // namespace

TEST_CASE("a clean domain comes back as it was") {
  domain_repairs repairs;
  const domain d = accepted(square(), &repairs);
  REQUIRE_FALSE(repairs.any());
  REQUIRE(d.vertices == square().vertices);
  for (std::size_t s = 0; s < 4; ++s) {
    REQUIRE(d.segments[s].a == s);
    REQUIRE(d.segments[s].b == (s + 1) % 4);
    REQUIRE(d.segments[s].marker == static_cast<int>(s) + 1);
  }
}

TEST_CASE("a clockwise ring is turned round") {
  const domain d = accepted(rings({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}));
  REQUIRE(doubled_area(d) == 2);
}

TEST_CASE("a ring with a hole, whichever way it runs") {
  const domain ring = rings({box(0, 0, 4, 4), box(1, 1, 3, 3)}, {{2, 2}});
  const domain d = accepted(ring);
  REQUIRE(d.segments.size() == 8);
  REQUIRE(doubled_area(d) == 24);
  REQUIRE(contains(d, {0.5, 2}));
  REQUIRE_FALSE(contains(d, {2, 2}));
  REQUIRE_FALSE(contains(d, {1, 2}));
  REQUIRE_FALSE(contains(d, {1, 1}));
  REQUIRE_FALSE(contains(d, {5, 1}));
}

TEST_CASE("an island in a hole, and a hole in the island") {
  const domain d = accepted(rings(
      {box(0, 0, 8, 8), box(1, 1, 7, 7), box(2, 2, 6, 6), box(3, 3, 5, 5)}, {{1.5, 1.5}, {4, 4}}));
  REQUIRE(doubled_area(d) == 2 * (64 - 36 + 16 - 4));
}

TEST_CASE("rings beside each other are separate parts") {
  const domain d = accepted(rings({box(0, 0, 1, 1), box(2, 0, 3, 1), box(0, 5, 3, 6)}));
  REQUIRE(doubled_area(d) == 10);
}

TEST_CASE("rings that touch in a vertex, in a repeated vertex, and inside a segment") {
  domain_repairs repairs;
  // The diamond touches the left side of the square in (0,2), inside a segment.
  const domain d =
      accepted(rings({box(0, 0, 4, 4), {{0, 2}, {1, 1}, {2, 2}, {1, 3}}}, {{1, 2}}), &repairs);
  REQUIRE(repairs.split_segments == 1);
  REQUIRE(d.segments.size() == 9);
  REQUIRE(doubled_area(d) == 32 - 4);
  const domain hourglass = accepted(rings({box(0, 0, 1, 1), box(1, 1, 2, 2)}), &repairs);
  REQUIRE(repairs.merged_vertices == 1);
  REQUIRE(hourglass.vertices.size() == 7);
  REQUIRE(doubled_area(hourglass) == 4);
}

TEST_CASE("repeated points and segments without length") {
  domain d = rings({{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}});
  domain_repairs repairs;
  const domain clean = accepted(d, &repairs);
  REQUIRE(clean.vertices.size() == 4);
  REQUIRE(clean.segments.size() == 4);
  REQUIRE(repairs.merged_vertices == 1);
  REQUIRE(repairs.segments_without_length == 1);
  REQUIRE(repairs.messages.at(0) ==
          "test: repeated vertices merged: 1, vertex 3 (1, 0) is vertex 2 (1, 0)");
}

TEST_CASE("overlapping collinear segments are united") {
  // The long bottom overlaps two shorter subsegments of another ring's top.
  domain d;
  d.vertices = {{0, 0}, {3, 0}, {3, 1}, {0, 1}, {1, 0}, {2, 0}};
  d.segments = {{0, 1, 0}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}, {4, 5, 9}, {5, 4, 8}, {0, 5, 7}};
  domain_repairs repairs;
  const domain clean = accepted(d, &repairs);
  REQUIRE(clean.segments.size() == 6);
  REQUIRE(repairs.split_segments == 2);
  REQUIRE(repairs.repeated_subsegments == 4);
  for (const segment& s : clean.segments)
    if (clean.vertices[s.a] == point{1, 0}) REQUIRE(s.marker == 9);
}

TEST_CASE("two holes with a common side, and a hole along the outside") {
  domain_repairs repairs;
  const domain common = accepted(
      rings({box(0, 0, 8, 8), box(2, 2, 4, 6), box(4, 2, 6, 6)}, {{3, 3}, {5, 3}}), &repairs);
  REQUIRE(repairs.outer_subsegments == 1);
  REQUIRE(doubled_area(common) == 2 * (64 - 16));
  const domain notch = accepted(rings({box(0, 0, 8, 8), box(0, 2, 4, 6)}, {{1, 3}}), &repairs);
  REQUIRE(repairs.outer_subsegments == 1);
  REQUIRE(notch.holes.empty());
  REQUIRE(doubled_area(notch) == 2 * (64 - 16));
}

TEST_CASE("loose vertices are kept inside and dropped elsewhere") {
  domain d = rings({box(0, 0, 4, 4), box(1, 1, 3, 3)}, {{2, 2}});
  d.vertices.push_back({0.5, 0.5});
  d.vertices.push_back({1.5, 1.5});  // in the hole
  d.vertices.push_back({9, 9});
  d.vertices.push_back({4, 2});  // on a segment
  d.vertices.push_back({0.5, 2});
  domain_repairs repairs;
  const domain clean = accepted(d, &repairs);
  REQUIRE(repairs.dropped_vertices == 2);
  REQUIRE(repairs.split_segments == 1);
  REQUIRE(clean.vertices.size() == 11);
  REQUIRE(clean.vertices.back() == point{0.5, 2});
  REQUIRE(clean.segments.size() == 9);
}

TEST_CASE("points one unit in the last place off a segment are beside it") {
  domain d = rings({{{0, 0}, {3, 1}, {0, 3}}});
  const double x = 1.5;
  d.vertices.push_back({x, std::nextafter(0.5, 1)});
  d.vertices.push_back({x, std::nextafter(0.5, 0)});
  domain_repairs repairs;
  REQUIRE(accepted(d, &repairs).vertices.size() == 4);
  REQUIRE(repairs.split_segments == 0);
  REQUIRE(repairs.dropped_vertices == 1);
}

TEST_CASE("impossible domains are refused by name") {
  REQUIRE(refusal(rings({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}})) ==
          "test: segment 3 (vertices 3-4) crosses segment 1 (vertices 1-2)");
  domain open = square();
  open.segments.pop_back();
  REQUIRE(
      refusal(open) ==
      "square: the boundary is not closed: it ends at vertex 1 (-1, -1), the end of segment 1 "
      "(vertices 1-2) alone, and at vertex 4 (-1, 1), the end of segment 3 (vertices 3-4) alone");
  REQUIRE(refusal(rings({box(0, 0, 4, 4)}, {{5, 5}})) ==
          "test: hole 1 (5, 5) lies outside of the domain");
  REQUIRE(refusal(rings({box(0, 0, 4, 4)}, {{4, 1}})) ==
          "test: hole 1 (4, 1) lies on segment 2 (vertices 2-3)");
  REQUIRE_THAT(refusal(rings({box(0, 0, 4, 4)}, {{1, 1}})), Catch::Contains("leave nothing"));
  REQUIRE(refusal(domain{}) == "the domain is empty: it has no segments");
  REQUIRE(refusal(rings({{{0, 0}, {1, 0}}})) ==
          "test: the domain is empty: its segments enclose nothing");
  domain infinite = square();
  infinite.vertices[2].x = std::numeric_limits<double>::infinity();
  REQUIRE(refusal(infinite) == "square: vertex 3 (inf, 1) is not finite");
  domain missing = square();
  missing.segments[1].b = 77;
  REQUIRE_THAT(refusal(missing), Catch::Contains("uses a vertex that does not exist"));
}

TEST_CASE("names follow the file a domain came from") {
  domain d = rings({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
  d.origin = {"x.poly", "x.poly", 0, {3, 4, 5, 6}, {8, 9, 10, 11}, {}};
  REQUIRE(refusal(d) ==
          "x.poly:10: segment 2 (vertices 2-3) crosses segment 0 (vertices 0-1) on line 8");
}

TEST_CASE("a domain far beyond ordinary magnitudes") {
  for (const double scale : {0x1p-400, 0x1p400}) {
    domain d = rings({box(0, 0, 4 * scale, 4 * scale), box(scale, scale, 3 * scale, 3 * scale)},
                     {{2 * scale, 2 * scale}});
    d.vertices.push_back({scale / 2, scale / 2});
    const domain clean = accepted(d);
    REQUIRE(clean.vertices.size() == 9);
    REQUIRE(contains(clean, {scale / 2, scale}));
    REQUIRE_FALSE(contains(clean, {scale, scale * 1.5}));
  }
}
