// SPDX-License-Identifier: MIT
#include "asterism/mesh/stars/star.hpp"

#include <catch2/catch.hpp>

#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

std::vector<site> isotropic(const std::vector<point>& points) {
  std::vector<site> sites;
  sites.reserve(points.size());
  for (const point& q : points) sites.push_back({q, {1, 0, 1}});
  return sites;
}

}  // namespace

TEST_CASE("sites are located in exact counter-clockwise order") {
  // Neighbours of site 0 at east, north, west, south; then probes.
  const star_setting setting(isotropic({{0, 0},
                                        {1, 0},
                                        {0, 1},
                                        {-1, 0},
                                        {0, -1},  // star
                                        {1, 1e-300},
                                        {1, -1e-300},
                                        {-3, 0},
                                        {-1, -1}}));
  const site_oracle oracle = setting.oracle();
  const sector s{{1, 2, 3, 4}, true};
  CHECK(locate(oracle, 0, s, 5).kind == placement_kind::in_gap);
  CHECK(locate(oracle, 0, s, 5).at == 0);
  CHECK(locate(oracle, 0, s, 6).at == 3);
  CHECK(locate(oracle, 0, s, 7).kind == placement_kind::on_ray);
  CHECK(locate(oracle, 0, s, 7).at == 2);
  CHECK(locate(oracle, 0, s, 8).at == 2);
}

TEST_CASE("an open sector may be wider than half a turn, and has an outside") {
  const star_setting setting(
      isotropic({{0, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, 0}, {1, -1}, {2, 0}}));
  const site_oracle oracle = setting.oracle();
  const sector s{{1, 4, 2}, false};  // from east over west to south
  CHECK(locate(oracle, 0, s, 3).kind == placement_kind::in_gap);
  CHECK(locate(oracle, 0, s, 3).at == 0);
  CHECK(locate(oracle, 0, s, 5).kind == placement_kind::outside);
  CHECK(locate(oracle, 0, s, 6).kind == placement_kind::on_ray);
}

TEST_CASE("gaps of a star with very many neighbours are found as in one with few") {
  std::vector<point> places = {{0, 0}};
  for (int x = -30; x < 30; ++x) places.push_back({static_cast<double>(x), -30});
  for (int y = -30; y < 30; ++y) places.push_back({30, static_cast<double>(y)});
  for (int x = 30; x > -30; --x) places.push_back({static_cast<double>(x), 30});
  for (int y = 30; y > -30; --y) places.push_back({-30, static_cast<double>(y)});
  const star_setting setting(isotropic(places));
  const site_oracle oracle = setting.oracle();
  for (const bool closed : {true, false}) {
    sector s{{}, closed};
    for (vertex_index w = 1; w < places.size(); w += 2) s.neighbours.push_back(w);
    if (!closed) s.neighbours.push_back(1);  // a slit (one subsegment on both sides)
    for (std::size_t gap = 0; gap < s.gaps(); ++gap) {
      const vertex_index y = s.neighbours[gap], x = s.neighbours[s.after(gap)];
      CHECK(gap_from(oracle, 0, s, y, x) == gap);
      CHECK_FALSE(gap_from(oracle, 0, s, x, y));
      CHECK_FALSE(gap_from(oracle, 0, s, y + 1, x));
      CHECK_FALSE(gap_from(oracle, 0, s, y, x + 1));
      CHECK_FALSE(gap_from(oracle, 0, s, 0, x));
    }
  }
}

TEST_CASE("a gap holds a triangle only below 180 degrees") {
  const star_setting setting(isotropic({{0, 0}, {1, 0}, {0, 1}, {-1, 0}}));
  const site_oracle oracle = setting.oracle();
  const sector s{{1, 2, 3}, true};
  CHECK(holds_triangle(oracle, 0, s, 0));
  CHECK(holds_triangle(oracle, 0, s, 1));
  CHECK_FALSE(holds_triangle(oracle, 0, s, 2));  // exactly 180
  CHECK(has_triangle(oracle, 0, {{s}}, 1, 2));
  CHECK_FALSE(has_triangle(oracle, 0, {{s}}, 2, 1));
  CHECK_FALSE(has_triangle(oracle, 0, {{s}}, 3, 1));
}

TEST_CASE("of two sites on one ray only the nearer stays, whatever the order") {
  const star_setting setting(isotropic({{0, 0}, {1, 1}, {2, 2}}));
  const site_oracle oracle = setting.oracle();
  star far_first = closed_star({}), near_first = closed_star({});
  CHECK(offer(oracle, 0, far_first, 2));
  CHECK(offer(oracle, 0, far_first, 1));
  CHECK(offer(oracle, 0, near_first, 1));
  CHECK_FALSE(offer(oracle, 0, near_first, 2));
  CHECK(far_first == closed_star({1}));
  CHECK(near_first == far_first);
}

TEST_CASE("a site strictly inside a triangle of the star is inserted") {
  const star_setting setting(isotropic({{0, 0}, {4, -1}, {4, 1}, {1, 0}}));
  star s = closed_star({1, 2});
  CHECK(offer(setting.oracle(), 0, s, 3));
  CHECK(s.contains(3));
}

TEST_CASE("inserting a near site removes neighbours on both sides") {
  // With equal metrics a star is the Delaunay star: the square around site 0 replaces a ring
  // farther away.
  const star_setting setting(isotropic({{0, 0},
                                        {9, 1},
                                        {-1, 9},
                                        {-9, -1},
                                        {1, -9},  //
                                        {1, 0},
                                        {0, 1},
                                        {-1, 0},
                                        {0, -1}}));
  const site_oracle oracle = setting.oracle();
  star s = closed_star({1, 2, 3, 4});
  for (vertex_index w = 5; w < 9; ++w) CHECK(offer(oracle, 0, s, w));
  CHECK(ring_of(s) == std::vector<vertex_index>{5, 6, 7, 8});
  CHECK_FALSE(prune(oracle, 0, s));
}

TEST_CASE("forced neighbours stay, and nothing is inserted on their rays") {
  // Site 4 is inside, site 5 on the ray beyond a forced end; both are near corner 0.
  domain d = polygon({{0, 0}, {1, 0}, {4, 4}, {0, 1}});
  d.vertices.push_back({0.25, 0.25});
  const star_setting setting(d);
  const constructed_star built = construct_star(setting.oracle(), 0);
  CHECK(built.settled);
  const sector& s = built.content.sectors.at(0);
  CHECK_FALSE(s.closed);
  CHECK(s.neighbours == std::vector<vertex_index>{1, 4, 3});
}

TEST_CASE("with equal metrics stars are the Delaunay ones, far neighbours and near") {
  // A 5 x 5 grid, skewed and squeezed so that no four points are cocircular.
  std::vector<site> sites;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      sites.push_back({{i + 0.31 * j + 0.01 * i * j * j, j + 0.02 * i * i}, {1, 0, 1}});
  const star_setting setting(sites);
  const site_oracle oracle = setting.oracle();
  const star s = construct_star(oracle, 12).content;
  for (std::size_t gap = 0; gap < s.sectors[0].gaps(); ++gap) {
    const vertex_index y = s.sectors[0].neighbours[gap];
    const vertex_index x = s.sectors[0].neighbours[s.sectors[0].after(gap)];
    REQUIRE(holds_triangle(oracle, 12, s.sectors[0], gap));
    for (vertex_index w = 0; w < sites.size(); ++w) {
      if (w == 12 || w == x || w == y) continue;
      // Evaluates in-circle tests by determinants in long doubles, which are far from zero here.
      const auto row = [&](vertex_index k) {
        const long double dx = sites[k].position.x - sites[w].position.x;
        const long double dy = sites[k].position.y - sites[w].position.y;
        return std::array<long double, 3>{dx, dy, dx * dx + dy * dy};
      };
      const auto a = row(12), b = row(y), c = row(x);
      const long double det = a[0] * (b[1] * c[2] - b[2] * c[1]) -
                              a[1] * (b[0] * c[2] - b[2] * c[0]) +
                              a[2] * (b[0] * c[1] - b[1] * c[0]);
      CHECK(det < 0);
    }
  }
}

TEST_CASE("a constructed star does not depend on the numbering of the sites") {
  const auto points = square_with_points(7).vertices;
  const formula_field field = swirl_field(12);
  std::vector<site> forward, backward;
  for (const point& q : points) forward.push_back({q, field.at(q).value()});
  backward.assign(forward.rbegin(), forward.rend());
  const star_setting a(forward), b(backward);
  const auto last = static_cast<vertex_index>(points.size() - 1);
  for (vertex_index v = 0; v <= last; ++v) {
    auto mirrored = construct_star(b.oracle(), last - v).content;
    for (vertex_index& w : mirrored.sectors[0].neighbours) w = last - w;
    CHECK(ring_of(construct_star(a.oracle(), v).content) == ring_of(mirrored));
  }
}
