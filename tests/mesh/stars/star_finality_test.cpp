// SPDX-License-Identifier: MIT
//
// Compares final stars with a scan of all sites, and earlier confirmations of stars with sites
// added later.
#include "asterism/mesh/stars/star_finality.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_insertion.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;
using asterism::vertex_index;
using asterism::test::splitmix64;

namespace {

struct arrangement {
  std::string name;
  domain shape;
  formula_field field;
};

domain filled_square(int count, std::uint64_t seed, double scale, const point& offset, bool grid) {
  domain d = square();
  splitmix64 random(seed);
  for (int i = 0; i < count; ++i) {
    const double x = grid ? (i % 5 - 2) / 2.5 : random.real(-0.99, 0.99);
    const double y = grid ? (i / 5 - 2) / 2.5 : random.real(-0.99, 0.99);
    d.vertices.push_back({x, y});
  }
  for (point& q : d.vertices) q = {offset.x + scale * q.x, offset.y + scale * q.y};
  return d;
}

// Every site has another tensor, of condition up to `condition`.
formula_field wild_field(double condition) {
  return formula_field([condition](const point& q) {
    const double t = 40 * q.x + 31 * q.y, c = std::cos(t), s = std::sin(t);
    const double large = 1 + (condition - 1) * std::abs(std::sin(77 * q.x - 13 * q.y));
    return metric_tensor{large * c * c + s * s, (large - 1) * c * s, large * s * s + c * c};
  });
}

std::vector<arrangement> arrangements() {
  constexpr int count = 25;
  return {{"identity", filled_square(count, 3, 1, {}, false), identity_field()},
          {"grid", filled_square(count, 0, 1, {}, true), identity_field()},
          {"grid, swirl", filled_square(count, 0, 1, {}, true), swirl_field(24)},
          {"swirl", filled_square(count, 4, 1, {}, false), swirl_field(24)},
          {"wild", filled_square(count, 5, 1, {}, false), wild_field(9)},
          {"wilder", filled_square(count, 6, 1, {}, false), wild_field(1e3)},
          {"tiny", filled_square(count, 7, 0x1p-300, {}, false), constant_field({4, 1, 9})},
          {"huge", filled_square(count, 8, 0x1p300, {}, false), constant_field({4, 1, 9})},
          {"far", filled_square(count, 9, 1, {1e8, -1e8}, false), swirl_field(0)}};
}

bool accepts_none(const site_oracle& oracle, vertex_index v, const star& s) {
  for (vertex_index w = 0; w < oracle.size(); ++w)
    if (w != v && !s.contains(w) && would_accept(oracle, v, s, w)) return false;
  return true;
}

// Returns the star without neighbour i of a sector, if that neighbour may be removed.
star without(star s, std::size_t part, std::size_t i) {
  auto& list = s.sectors[part].neighbours;
  if (!s.sectors[part].is_forced(i)) list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
  return s;
}

}  // namespace

TEST_CASE("a star is final exactly when no site of all would be accepted") {
  std::size_t yes = 0, no = 0;
  for (const arrangement& a : arrangements()) {
    INFO(a.name);
    const indexed_setting now(a.shape, a.field);
    const site_oracle oracle = now.oracle(), of_all = now.of_all();
    for (vertex_index v = 0; v < oracle.size(); ++v) {
      const star whole = construct_star(of_all, v).content;
      std::vector<star> asked = {whole, empty_star(now.edges, v)};
      for (std::size_t part = 0; part < whole.sectors.size(); ++part)
        for (std::size_t i = 0; i < whole.sectors[part].size(); ++i)
          asked.push_back(without(whole, part, i));
      for (const star& s : asked) {
        const bool expected = accepts_none(of_all, v, s);
        INFO("star of site " << v << " with " << s.sectors[0].size() << " neighbours");
        REQUIRE(final_reach(oracle, v, s).has_value() == expected);
        ++(expected ? yes : no);
      }
    }
  }
  CHECK(yes > 250);
  CHECK(no > 500);
}

TEST_CASE("a reach that was found keeps out what comes later from farther away") {
  std::size_t kept_out = 0;
  for (const arrangement& a : arrangements()) {
    INFO(a.name);
    indexed_setting now(a.shape, a.field);
    const vertex_index before = now.oracle().size();
    std::vector<star> stars;
    std::vector<std::optional<double>> reaches;
    for (vertex_index v = 0; v < before; ++v) {
      stars.push_back(construct_star(now.of_all(), v).content);
      reaches.push_back(final_reach(now.oracle(), v, stars.back()));
    }
    splitmix64 random(21);
    site_index later(now.near.box());
    const point& low = now.near.box().low;
    const point size{now.near.box().high.x - low.x, now.near.box().high.y - low.y};
    for (int i = 0; i < 30; ++i) {
      const double x = random.real(0.01, 0.99), y = random.real(0.01, 0.99);
      const point q{low.x + x * size.x, low.y + y * size.y};
      now.sites.push_back({q, a.field.at(q).value()});
      now.near.add_site(now.sites, now.oracle().size() - 1);
      later.insert(now.sites, now.oracle().size() - 1);
    }
    for (vertex_index v = 0; v < before; ++v) {
      if (!reaches[v]) continue;
      std::vector<char> in_reach(now.sites.size(), 0);
      later.visit_reach(now.sites, now.sites[v], *reaches[v], [&](vertex_index w) {
        in_reach[w] = 1;
        return true;
      });
      for (vertex_index w = before; w < now.sites.size(); ++w) {
        if (in_reach[w] != 0) continue;
        ++kept_out;
        REQUIRE_FALSE(would_accept(now.of_all(), v, stars[v], w));
      }
    }
  }
  CHECK(kept_out > 200);
}

TEST_CASE("stars confirmed as sites come one by one are those of all sites at once") {
  for (const arrangement& a : arrangements()) {
    if (a.name == "wild" || a.name == "wilder") continue;  // takes seconds and adds no case
    INFO(a.name);
    indexed_setting now(a.shape, a.field);
    star_set stars;
    stars.construct_all(now.oracle());
    splitmix64 random(22);
    const point& low = now.near.box().low;
    const point size{now.near.box().high.x - low.x, now.near.box().high.y - low.y};
    for (int i = 0; i < 4; ++i) {
      const double x = random.real(0.01, 0.99), y = random.real(0.01, 0.99);
      const point q{low.x + x * size.x, low.y + y * size.y};
      now.sites.push_back({q, a.field.at(q).value()});
      now.near.add_site(now.sites, now.oracle().size() - 1);
      stars.add_last(now.oracle());
      if (i % 2 != 1) continue;
      std::vector<vertex_index> all(now.sites.size());
      std::iota(all.begin(), all.end(), vertex_index{0});
      stars.construct(now.oracle(), all, star_search::thorough);
      for (const vertex_index v : all) {
        INFO("after " << i + 1 << " sites, star of " << v);
        if (!stars.is_unsettled(v)) REQUIRE(accepts_none(now.of_all(), v, stars[v]));
      }
    }
  }
}

TEST_CASE("a right guess is the star at once, and a wrong one changes nothing") {
  std::size_t taken = 0, refused = 0;
  for (const arrangement& a : arrangements()) {
    if (a.name == "wild" || a.name == "wilder") continue;  // a star may have several results
    INFO(a.name);
    const indexed_setting now(a.shape, a.field);
    const site_oracle oracle = now.oracle();
    for (vertex_index v = 0; v < oracle.size(); ++v) {
      if (!oracle.edges().corners(v).empty()) continue;
      const constructed_star without = construct_star(oracle, v);
      if (!without.settled || without.content.sectors[0].size() < 4) continue;
      const std::vector<vertex_index>& ring = without.content.sectors[0].neighbours;
      std::vector<vertex_index> shorter(ring.begin() + 1, ring.end()),
          backwards = ring, twice = ring, with_itself = ring;
      std::reverse(backwards.begin(), backwards.end());
      twice.insert(twice.begin(), twice.front());
      with_itself.push_back(v);
      for (const auto& guess : {ring, shorter, backwards, twice, with_itself, {ring[0], ring[1]}}) {
        INFO("star of site " << v << ", guess of " << guess.size());
        const constructed_star made = construct_star(oracle, v, star_search::thorough, {guess});
        CHECK(ring_of(made.content) == ring_of(without.content));
        CHECK(made.settled);
      }
      const constructed_star near = construct_star(oracle, v, star_search::near, {ring});
      ++(near.final_reach ? taken : refused);
    }
  }
  CHECK(taken > 100);
  CHECK(refused < taken);
}

// A star at the rim of many sites has neighbours on the boundary far away, in another metric: these
// gaps have no bound on their reach.
TEST_CASE("a star is not held against all sites because one gap of it has no bound") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  domain d = square();
  splitmix64 random(46);
  for (int i = 0; i < 3000; ++i) {
    const double x = random.real(-0.9, 0.9), y = random.real(-0.9, 0.9);
    d.vertices.push_back({x, y});
  }
  const indexed_setting now(accepted(d), swirl_field(12));
  const auto asked = [&] { return now.decided.at(predicate::orientation, tier::semi_static); };
  std::size_t open = 0, looked_at = 0;
  for (vertex_index v = 0; v < now.sites.size(); ++v) {
    if (!now.edges.corners(v).empty()) continue;
    const star s = construct_star(now.oracle(), v, star_search::near).content;
    const auto before = asked();
    const auto reach = final_reach(now.oracle(), v, s);
    if (!reach || *reach < infinity) continue;
    ++open;
    looked_at += asked() - before;
  }
  INFO(open << " stars, " << looked_at << " questions");
  CHECK(open > 10);
  CHECK(looked_at < open * now.sites.size() / 4);
}
