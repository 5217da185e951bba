// SPDX-License-Identifier: MIT
//
// Internal segments in the boundary and in the stars: both sides, free ends, splits.
#include <catch2/catch.hpp>

#include "asterism/mesh/stars/consistency.hpp"
#include "asterism/mesh/stars/star_set.hpp"
#include "asterism/mesh/stars/strictly_inside.hpp"
#include "asterism/mesh/stars/visibility.hpp"
#include "fixtures/domain_kinds.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// The square with a segment from the middle of its lower side (4) to (0, 0) (5), and sites 6 and 7
// on its two sides.
domain slit_square() {
  domain d = square();
  d.vertices.push_back({0, -1});
  d.vertices.push_back({0, 0});
  d.segments.push_back({4, 5, 5});
  d.vertices.push_back({-0.25, -0.5});
  d.vertices.push_back({0.25, -0.5});
  return accepted(d);
}

std::size_t place_of(const boundary& b, vertex_index from, vertex_index to) {
  for (std::size_t i = 0; i < b.subsegments().size(); ++i)
    if (b.subsegments()[i].a == from && b.subsegments()[i].b == to) return i;
  FAIL("no piece " << from << " - " << to);
  return 0;
}

void check_twins(const boundary& b) {
  for (std::size_t i = 0; i < b.subsegments().size(); ++i) {
    const auto twin = b.twin(i);
    REQUIRE(twin.has_value() == b.subsegments()[i].internal);
    if (!twin) continue;
    CHECK(b.twin(*twin) == i);
    CHECK(b.subsegments()[*twin].a == b.subsegments()[i].b);
    CHECK(b.subsegments()[*twin].b == b.subsegments()[i].a);
  }
}

}  // namespace

TEST_CASE("an internal segment is two pieces with a corner on each side of its ends") {
  const star_setting setting(slit_square());
  const boundary& b = setting.edges;
  CHECK(b.subsegments().size() == 7);
  check_twins(b);
  CHECK(b.is_subsegment(4, 5));
  CHECK(b.is_subsegment(5, 4));
  REQUIRE(b.corners(4).size() == 2);
  for (const boundary_corner& c : b.corners(4)) CHECK((c.first == 5) != (c.last == 5));
  REQUIRE(b.corners(5).size() == 1);
  CHECK(b.corners(5)[0].first == 4);
  CHECK(b.corners(5)[0].last == 4);
  CHECK(b.corners(6).empty());
  const auto chain = b.in_order();
  CHECK(chain.size() == 6);
  CHECK(std::count_if(chain.begin(), chain.end(),
                      [](const boundary_edge& e) { return e.internal; }) == 1);
}

TEST_CASE("around a free end every direction has its place once") {
  const star_setting setting(slit_square());
  const site_oracle oracle = setting.oracle();
  star tip = empty_star(setting.edges, 5);
  sector& s = tip.sectors.at(0);
  CHECK(s.is_slit());
  for (const vertex_index w : {0u, 1u, 2u, 3u, 6u, 7u})
    CHECK(locate(oracle, 5, s, w).kind == placement_kind::in_gap);
  s.neighbours = {4, 7, 2, 3, 4};
  CHECK(locate(oracle, 5, s, 4).kind == placement_kind::on_ray);
  CHECK(locate(oracle, 5, s, 7).at == 1);
  CHECK(locate(oracle, 5, s, 1).kind == placement_kind::in_gap);
  CHECK(locate(oracle, 5, s, 1).at == 1);
  CHECK(locate(oracle, 5, s, 6).at == 3);
  CHECK(locate(oracle, 5, s, 0).kind == placement_kind::in_gap);
  CHECK(locate(oracle, 5, s, 0).at == 3);
}

TEST_CASE("sites do not see each other through an internal segment or its free end") {
  domain d = slit_square();
  d.vertices.push_back({0, 0.5});
  const star_setting setting(d);
  const site_oracle oracle = setting.oracle();
  CHECK_FALSE(oracle.visible(6, 7));
  CHECK(oracle.visible(6, 5));
  CHECK_FALSE(oracle.visible(8, 4));  // along the segment, through its end
  CHECK(oracle.visible(6, 3));
  const auto inside = [&](const point& q) {
    return strictly_inside(setting.edges, setting.sites, setting.kernel, q);
  };
  CHECK(inside({-0.5, -0.25}));
  CHECK(inside({0.5, -0.25}));
  CHECK_FALSE(inside({0, -0.25}));
  CHECK_FALSE(inside({0, 0}));
  CHECK(inside({0, std::nextafter(0.0, 1.0)}));
}

TEST_CASE("an internal segment is split on both sides at once") {
  star_setting setting(slit_square());
  star_set stars;
  stars.construct_all(setting.oracle());
  CHECK_FALSE(stars[6].contains(7));
  CHECK(check_consistency(setting.oracle(), stars).consistent());
  // Splits in both directions, and then splits a part again.
  const auto split = [&](vertex_index a, vertex_index b, const point& at) {
    const auto m = static_cast<vertex_index>(setting.sites.size());
    setting.sites.push_back({at, {1, 0, 1}});
    setting.edges.split(place_of(setting.edges, a, b), m);
    stars.split_subsegment(setting.oracle(), a, m, b);
    check_twins(setting.edges);
    for (const auto& [from, to] : {std::pair{a, m}, {m, a}, {m, b}, {b, m}})
      CHECK(setting.edges.is_subsegment(from, to));
    CHECK_FALSE(setting.edges.is_subsegment(a, b));
    CHECK_FALSE(setting.edges.is_subsegment(b, a));
    CHECK(setting.edges.corners(m).size() == 2);
    for (vertex_index v = 0; v < stars.size(); ++v) stars.rebuild(setting.oracle(), v);
    CHECK(check_consistency(setting.oracle(), stars).consistent());
  };
  split(5, 4, {0, -0.5});
  split(4, 8, {0, -0.75});
  const auto chain = setting.edges.in_order();
  REQUIRE(chain.size() == 8);
  std::vector<boundary_edge> internal;
  for (const boundary_edge& e : chain)
    if (e.internal) internal.push_back(e);
  REQUIRE(internal.size() == 3);
  CHECK(internal[0].a == 4);
  CHECK(internal[0].b == 9);
  CHECK(internal[1].b == 8);
  CHECK(internal[2].b == 5);
}

TEST_CASE("a split point off an internal segment hides what it cuts off, on either side") {
  for (const double side : {1.0, -1.0}) {
    domain d = square();
    d.segments.push_back({0, 2, 5});
    // Two sites so near the diagonal that a vertex beside its middle separates them.
    const point off{-0.0125 * side, 0.0125 * side};
    d.vertices.push_back({-0.5 + off.x, -0.5 + off.y});
    d.vertices.push_back({0.5 + off.x, 0.5 + off.y});
    star_setting setting(accepted(d));
    star_set stars;
    stars.construct_all(setting.oracle());
    REQUIRE(stars[4].contains(5));
    setting.sites.push_back({{-0.02 * side, 0.02 * side}, {1, 0, 1}});
    setting.edges.split(place_of(setting.edges, 0, 2), 6);
    stars.split_subsegment(setting.oracle(), 0, 6, 2);
    CHECK_FALSE(stars[4].contains(5));
    CHECK(stars[4].contains(6));
  }
}

TEST_CASE("the stars of every kind of domain settle") {
  for (const named_domain& kind : domain_kinds()) {
    INFO(kind.name);
    const star_setting setting(kind.shape);
    check_twins(setting.edges);
    star_set stars;
    stars.construct_all(setting.oracle());
    for (vertex_index v = 0; v < stars.size(); ++v) CHECK_FALSE(stars.is_unsettled(v));
  }
}
