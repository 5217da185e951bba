// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/built_in_domains.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/point_in_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"

using namespace asterism;
using namespace asterism::internal;

TEST_CASE("random points are inside, distinct and the same for one seed") {
  const auto a = add_random_points(square(), 1000, 42), b = add_random_points(square(), 1000, 42);
  const auto c = add_random_points(square(), 1000, 43);
  REQUIRE(a.ok());
  REQUIRE(a.value().vertices.size() == 1004);
  REQUIRE(a.value().vertices == b.value().vertices);
  REQUIRE(a.value().vertices != c.value().vertices);
  std::set<std::pair<double, double>> places;
  for (std::size_t v = 4; v < 1004; ++v) {
    const auto [x, y] = a.value().vertices[v];
    REQUIRE((std::abs(x) <= 0.9 && std::abs(y) <= 0.9));
    places.insert({x, y});
  }
  REQUIRE(places.size() == 1000);
  domain_repairs repairs;
  REQUIRE(check_domain(a.value(), &repairs).value().vertices == a.value().vertices);
  REQUIRE_FALSE(repairs.any());
}

TEST_CASE("the first random point has these bits everywhere") {
  // Computed by splitmix64 and the same arithmetic in another language.
  const auto d = add_random_points(square(), 1, 1);
  REQUIRE(d.value().vertices[4] == point{0x1.eabec435d0434p-4, 0x1.c5066223a804fp-2});
}

TEST_CASE("many random points are numbered along a curve") {
  const domain d = add_random_points(square(), 5000, 42).value();
  double way = 0;
  for (std::size_t v = 5; v < d.vertices.size(); ++v)
    way += std::hypot(d.vertices[v].x - d.vertices[v - 1].x, d.vertices[v].y - d.vertices[v - 1].y);
  CHECK(way < 200);  // about 4700 in the order drawn
}

TEST_CASE("random points stay out of holes") {
  const auto checked = check_domain(airfoil().value());
  const auto d = add_random_points(checked.value(), 300, 5);
  REQUIRE(d.ok());
  for (std::size_t v = checked.value().vertices.size(); v < d.value().vertices.size(); ++v)
    REQUIRE(contains(checked.value(), d.value().vertices[v]));
}

TEST_CASE("a domain that fills almost nothing of its box has no room for random points") {
  domain sliver;
  sliver.name = "sliver";
  sliver.vertices = {{0, 0}, {1, 1}, {0.5, 0.5 + 1e-9}};
  sliver.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  const auto d = add_random_points(sliver, 3, 1);
  REQUIRE_FALSE(d.ok());
  REQUIRE_THAT(d.failure().message, Catch::Contains("missed the inside of sliver"));
}

TEST_CASE("the airfoil is closed, symmetric and 12 percent thick") {
  const auto made = airfoil({60, {{-2, -1}, {3, 1.5}}});
  REQUIRE(made.ok());
  const domain& d = made.value();
  REQUIRE(d.vertices.size() == 4 + 120);
  REQUIRE(d.vertices[4] == point{1, 0});
  REQUIRE(d.vertices[64] == point{0, 0});
  double thickest = 0;
  for (std::size_t i = 1; i < 60; ++i) {
    REQUIRE(d.vertices[64 + i].x == d.vertices[64 - i].x);
    REQUIRE(d.vertices[64 + i].y == -d.vertices[64 - i].y);
    thickest = std::max(thickest, d.vertices[64 + i].y);
  }
  REQUIRE(thickest == Approx(0.06).epsilon(0.005));
  domain_repairs repairs;
  REQUIRE(check_domain(d, &repairs).ok());
  REQUIRE_FALSE(repairs.any());
}

TEST_CASE("airfoils that make no sense are refused") {
  REQUIRE_THAT(airfoil({1, {{-1, -1}, {2, 1}}}).failure().message, Catch::Contains("1 intervals"));
  REQUIRE_FALSE(airfoil({40, {{0, -1}, {2, 1}}}).ok());
  REQUIRE_FALSE(airfoil({40, {{-1, -1}, {2, NAN}}}).ok());
}

TEST_CASE("domains by name") {
  REQUIRE(load_domain("square").value().vertices.size() == 4);
  REQUIRE(load_domain("naca0012").value().vertices == load_domain("airfoil").value().vertices);
  REQUIRE_THAT(load_domain("circle").failure().message, Catch::Contains("unknown domain 'circle'"));
  REQUIRE_THAT(load_domain("none.poly").failure().message,
               Catch::Contains("none.poly: no such file"));
}
