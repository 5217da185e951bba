// SPDX-License-Identifier: MIT
//
// Compares what polygons contain with rules that are evaluated at every cell of a grid,
// independently of other cells.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/repair_domain.hpp"

using namespace asterism;
using internal::splitmix64;

namespace {

using ring = std::vector<point>;

void add_polygon(domain& d, const std::vector<ring>& rings, std::optional<int> region = {}) {
  domain_polygon& made = d.polygons.emplace_back();
  made.region = region;
  for (const ring& corners : rings) {
    const auto first = static_cast<vertex_index>(d.vertices.size());
    const auto n = static_cast<vertex_index>(corners.size());
    d.vertices.insert(d.vertices.end(), corners.begin(), corners.end());
    made.rings.emplace_back();
    for (vertex_index i = 0; i < n; ++i) {
      made.rings.back().push_back(static_cast<std::uint32_t>(d.segments.size()));
      d.segments.push_back({first + i, first + (i + 1) % n, static_cast<int>(d.polygons.size())});
    }
  }
}

ring box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

domain accepted(const domain& d, domain_repairs* repairs = nullptr) {
  const auto checked = check_domain(d, repairs);
  INFO((checked.ok() ? "" : checked.failure().message));
  REQUIRE(checked.ok());
  return checked.value();
}

std::string refusal(const domain& d) {
  const auto checked = check_domain(d);
  REQUIRE_FALSE(checked.ok());
  return checked.failure().message;
}

// Returns the areas by region, exact where twice the products of coordinates are.
std::map<int, double> areas(const domain& d) {
  std::map<int, double> found;
  for (const segment& s : d.segments) {
    const point &a = d.vertices[s.a], &b = d.vertices[s.b];
    const double part = (a.x * b.y - a.y * b.x) / 2;
    found[s.left_region] += part;
    if (s.internal) found[s.right_region] -= part;
  }
  std::erase_if(found, [](const auto& entry) { return entry.second == 0; });
  return found;
}

long internal_count(const domain& d) {
  return std::count_if(d.segments.begin(), d.segments.end(),
                       [](const segment& s) { return s.internal; });
}

using by_region = std::map<int, double>;

}  // namespace

TEST_CASE("a part that fills another part's hole is there, the ring between them inside") {
  domain d;
  add_polygon(d, {box(0, 0, 3, 3), box(1, 1, 2, 2)});
  add_polygon(d, {box(1, 1, 2, 2)});
  const domain made = accepted(d);
  CHECK(areas(made) == by_region{{1, 9}});
  CHECK(internal_count(made) == 4);
}

TEST_CASE("a feature in another one's hole is a region, and a gap between features is none") {
  domain d;
  add_polygon(d, {box(0, 0, 3, 3), box(1, 1, 2, 2)}, 1);
  add_polygon(d, {box(1, 1, 2, 2)}, 2);
  CHECK(areas(accepted(d)) == by_region{{1, 8}, {2, 1}});
  domain gap;  // four parts around a square that belongs to none of them
  add_polygon(gap, {{{0, 0}, {3, 0}, {2, 1}, {1, 1}}});
  add_polygon(gap, {{{3, 0}, {3, 3}, {2, 2}, {2, 1}}});
  add_polygon(gap, {{{3, 3}, {0, 3}, {1, 2}, {2, 2}}});
  add_polygon(gap, {{{0, 3}, {0, 0}, {1, 1}, {1, 2}}});
  CHECK(areas(accepted(gap)) == by_region{{1, 8}});
}

TEST_CASE("rings in rings in rings") {
  domain d;
  add_polygon(d, {box(0, 0, 9, 9), box(1, 1, 8, 8)}, 3);
  add_polygon(d, {box(2, 2, 7, 7), box(3, 3, 6, 6)}, 1);
  add_polygon(d, {box(4, 4, 5, 5)}, 2);
  CHECK(areas(accepted(d)) == by_region{{1, 16}, {2, 1}, {3, 32}});
}

TEST_CASE("holes at a corner, along a side, side by side, across a part's outside") {
  domain d;
  add_polygon(d, {box(0, 0, 4, 4), {{0, 0}, {2, 1}, {1, 2}}});
  CHECK(areas(accepted(d)) == by_region{{1, 14.5}});
  domain beside;
  add_polygon(beside, {box(0, 0, 4, 4), box(0, 1, 2, 2)});
  CHECK(areas(accepted(beside)) == by_region{{1, 14}});
  domain two;
  add_polygon(two, {box(0, 0, 4, 4), box(1, 1, 2, 2), box(2, 1, 3, 2)});
  CHECK(areas(accepted(two)) == by_region{{1, 14}});
  domain beyond;  // a hole outside of its own polygon, inside another
  add_polygon(beyond, {box(0, 0, 4, 4), box(5, 1, 6, 2)});
  add_polygon(beyond, {box(4, 0, 8, 4)});
  CHECK(areas(accepted(beyond)) == by_region{{1, 32}});
}

TEST_CASE("rings that meet themselves enclose what is inside by parity") {
  domain inverted;  // a hole in the form of a loop of the outer ring
  add_polygon(inverted, {{{0, 0}, {4, 0}, {4, 2}, {3, 1}, {3, 3}, {4, 2}, {4, 4}, {0, 4}}});
  CHECK(areas(accepted(inverted)) == by_region{{1, 15}});
  domain spike;
  add_polygon(spike, {{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}}});
  CHECK(areas(accepted(spike)) == by_region{{1, 16}});
  domain crossed;
  add_polygon(crossed, {{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, 7);
  using Catch::Contains;
  CHECK_THAT(refusal(crossed), Contains("the side (2, 0) - (0, 2) of polygon 1 (feature 7) crosses "
                                        "the side (0, 0) - (2, 2) of polygon 1 (feature 7)"));
  const auto mended = repair_domain(crossed);
  REQUIRE(mended.ok());
  CHECK(areas(mended.value()) == by_region{{7, 2}});
}

TEST_CASE("of features that overlap the first has what they share, and a note says so") {
  for (const bool inner_first : {true, false}) {
    domain d;
    const ring outer = box(0, 0, 4, 4), inner = box(1, 1, 3, 3);
    add_polygon(d, {inner_first ? inner : outer}, 1);
    add_polygon(d, {inner_first ? outer : inner}, 2);
    domain_repairs repairs;
    const domain made = accepted(d, &repairs);
    CHECK(areas(made) == (inner_first ? by_region{{1, 4}, {2, 12}} : by_region{{1, 16}}));
    CHECK(internal_count(made) == 4);
    CHECK(repairs.shared_parts == 1);
    REQUIRE(repairs.messages.size() == 1);
    CHECK(repairs.messages[0].find("feature 1 and feature 2") != std::string::npos);
  }
  domain twice;
  add_polygon(twice, {box(0, 0, 4, 4)}, 1);
  add_polygon(twice, {box(0, 0, 4, 4)}, 2);
  domain_repairs repairs;
  CHECK(areas(accepted(twice, &repairs)) == by_region{{1, 16}});
  CHECK(repairs.shared_parts == 1);
}

TEST_CASE("features that cross are refused by both names, and mended") {
  domain d;
  add_polygon(d, {box(0, 0, 4, 4)}, 1);
  add_polygon(d, {box(2, 2, 6, 6)}, 2);
  using Catch::Contains;
  CHECK_THAT(refusal(d),
             Contains("polygon 2 (feature 2) crosses") && Contains("of polygon 1 (feature 1)"));
  domain_repairs repairs;
  const auto mended = repair_domain(d, {}, &repairs);
  REQUIRE(mended.ok());
  CHECK(areas(mended.value()) == by_region{{1, 16}, {2, 12}});
  CHECK(repairs.shared_parts == 1);
}

TEST_CASE("what polygons share is no repair that is told") {
  domain d;
  add_polygon(d, {box(0, 0, 4, 4)}, 1);
  add_polygon(d, {box(4, 1, 6, 3)}, 2);
  add_polygon(d, {box(4, 3, 6, 5)}, 3);
  domain_repairs repairs;
  const domain made = accepted(d, &repairs);
  CHECK(areas(made) == by_region{{1, 16}, {2, 4}, {3, 4}});
  CHECK(internal_count(made) == 3);
  CHECK(repairs.messages.empty());
}

TEST_CASE("rings that are not closed, or of segments that are not there, are refused") {
  domain d;
  add_polygon(d, {box(0, 0, 4, 4)});
  d.polygons[0].rings[0].pop_back();
  using Catch::Contains;
  CHECK_THAT(refusal(d), Contains("ring 1 of polygon 1 is not closed"));
  d.polygons[0].rings[0].push_back(4);
  CHECK_THAT(refusal(d), Contains("ring 1 of polygon 1 has a segment that does not exist"));
}

TEST_CASE("features keep their numbers where all regions are numbered") {
  domain d;
  add_polygon(d, {box(0, 0, 1, 1)}, 1);
  add_polygon(d, {box(1, 0, 2, 1)}, 3);
  add_polygon(d, {box(2, 0, 3, 1)});
  d.number_all_regions = true;
  CHECK(areas(accepted(d)) == by_region{{1, 1}, {2, 1}, {3, 1}});
  d.number_all_regions = false;
  CHECK(areas(accepted(d)) == by_region{{0, 1}, {1, 1}, {3, 1}});
}

namespace {

struct cell_box {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool has(int x, int y) const { return x0 <= x && x < x1 && y0 <= y && y < y1; }
};

struct cell_polygon {
  cell_box outer;
  std::vector<cell_box> holes;
  std::optional<int> feature;
  bool has(int x, int y) const {
    return outer.has(x, y) &&
           std::none_of(holes.begin(), holes.end(), [&](const cell_box& h) { return h.has(x, y); });
  }
};

constexpr int grid = 8;

cell_box random_box(splitmix64& random) {
  const auto below = [&](int n) { return static_cast<int>(random.bits() % std::uint64_t(n)); };
  const int x = below(grid), y = below(grid);
  return {x, y, x + 1 + below(grid - x), y + 1 + below(grid - y)};
}

// Returns the box's ring with a corner at every point of the grid on it, so that boxes meet in
// corners alone.
ring corners_of(const cell_box& b, double shake, splitmix64& random) {
  ring corners;
  const auto add = [&](int x, int y) {
    corners.push_back({x + shake * (random.real() - 0.5), y + shake * (random.real() - 0.5)});
  };
  for (int x = b.x0; x < b.x1; ++x) add(x, b.y0);
  for (int y = b.y0; y < b.y1; ++y) add(b.x1, y);
  for (int x = b.x1; x > b.x0; --x) add(x, b.y1);
  for (int y = b.y1; y > b.y0; --y) add(b.x0, y);
  return corners;
}

std::vector<cell_polygon> random_polygons(splitmix64& random) {
  const bool has_features = random.bits() % 2 == 0;
  std::vector<cell_polygon> all(1 + random.bits() % 5);
  for (cell_polygon& p : all) {
    p.outer = random_box(random);
    p.holes.resize(random.bits() % 3);
    for (cell_box& hole : p.holes) hole = random_box(random);
    if (has_features) p.feature = 1 + static_cast<int>(random.bits() % 4);
  }
  return all;
}

by_region expected_areas(const std::vector<cell_polygon>& all) {
  by_region areas;
  for (int x = 0; x < grid; ++x)
    for (int y = 0; y < grid; ++y) {
      std::optional<int> first;
      for (const cell_polygon& p : all)
        if (p.has(x, y)) first = std::min(first.value_or(9), p.feature.value_or(1));
      if (first) areas[*first] += 1;
    }
  return areas;
}

domain drawn(const std::vector<cell_polygon>& all, double shake, splitmix64& random) {
  domain d;
  for (const cell_polygon& p : all) {
    std::vector<ring> rings{corners_of(p.outer, shake, random)};
    for (const cell_box& hole : p.holes) rings.push_back(corners_of(hole, shake, random));
    add_polygon(d, rings, p.feature);
  }
  return d;
}

}  // namespace

TEST_CASE("random polygons contain what their formats say, cell by cell, and are accepted again") {
  constexpr std::uint64_t seed = 41;
  for (std::uint64_t round = 0; round < 400; ++round) {
    INFO("seed " << seed << ", round " << round);
    splitmix64 random(seed + 1000 * round);
    const std::vector<cell_polygon> all = random_polygons(random);
    const domain d = drawn(all, 0, random);
    const by_region wanted = expected_areas(all);
    if (wanted.empty()) {
      CHECK_FALSE(check_domain(d).ok());
      continue;
    }
    const domain made = accepted(d);
    CHECK(areas(made) == wanted);
    // A point on no segment stays if the domain contains its surroundings.
    domain dotted = d;
    std::vector<point> inside;
    for (int x = 0; x < grid; ++x)
      for (int y = 0; y < grid; ++y) {
        dotted.vertices.push_back({x + 0.5, y + 0.25});
        if (std::any_of(all.begin(), all.end(), [&](const auto& p) { return p.has(x, y); }))
          inside.push_back(dotted.vertices.back());
      }
    const domain spotted = accepted(dotted);
    std::vector<point> kept;
    for (const point& p : spotted.vertices)
      if (p.x != std::floor(p.x)) kept.push_back(p);
    CHECK(kept == inside);
    domain_repairs repairs;
    const domain again = accepted(made, &repairs);
    CHECK_FALSE(repairs.any());
    CHECK(again.segments.size() == made.segments.size());
    CHECK(areas(again) == wanted);
  }
}

TEST_CASE("repaired polygons contain what they did, but for the distance") {
  constexpr std::uint64_t seed = 43;
  constexpr double shake = 1e-4, distance = 1e-3;
  for (std::uint64_t round = 0; round < 100; ++round) {
    INFO("seed " << seed << ", round " << round);
    splitmix64 random(seed + 1000 * round);
    const std::vector<cell_polygon> all = random_polygons(random);
    const by_region wanted = expected_areas(all);
    if (wanted.empty()) continue;
    const auto made = repair_domain(drawn(all, shake, random), distance);
    INFO((made.ok() ? "" : made.failure().message));
    REQUIRE(made.ok());
    const by_region found = areas(made.value());
    for (const auto& [region, area] : wanted)
      CHECK(std::abs((found.contains(region) ? found.at(region) : 0) - area) < 0.05);
    CHECK(found.size() == wanted.size());
  }
}
