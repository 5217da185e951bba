// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/place_tree.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

point random_point(splitmix64& random) { return {random.real(), random.real()}; }

// Points, segments of all lengths, circles and boxes.
std::vector<sized_place> random_places(splitmix64& random, std::size_t count) {
  std::vector<sized_place> places;
  for (std::size_t i = 0; i < count; ++i) {
    const point a = random_point(random);
    const double extent = i % 3 == 0 ? 0 : std::ldexp(1, -static_cast<int>(i % 11));
    const point b{a.x + extent * random.real(), a.y + extent * random.real()};
    places.push_back({a, b, i % 5 == 0 ? 0.01 * random.real() : 0, i % 7 == 0, 0.1 * random.real(),
                      i % 2 == 0 ? 0.2 : random.real()});
  }
  return places;
}

TEST_CASE("the tree finds the place that looking at all of them finds", "[place_tree]") {
  splitmix64 random(11);
  for (const std::size_t count : {std::size_t{1}, std::size_t{5}, std::size_t{300}}) {
    const std::vector<sized_place> places = random_places(random, count);
    const place_tree tree(places);
    for (int k = 0; k < 2000; ++k) {
      const point q{3 * random.real() - 1, 3 * random.real() - 1};
      std::size_t best = 0;
      const auto size = [&](std::size_t i) {
        return places[i].size + places[i].slope * distance_from(q, places[i]);
      };
      for (std::size_t i = 1; i < count; ++i)
        if (size(i) < size(best)) best = i;
      const place_tree::found found = tree.least_at(q);
      CHECK(found.place == best);
      CHECK(found.size == size(best));
    }
  }
}

TEST_CASE("a tree without places allows any size", "[place_tree]") {
  CHECK(std::isinf(place_tree({}).least_at({0, 0}).size));
}

TEST_CASE("distances do not sink on the way from a long slanted segment", "[place_tree]") {
  const sized_place wall{{-1000.1, -2000.3}, {1733.7, 912.9}};
  splitmix64 random(5);
  for (int k = 0; k < 200; ++k) {
    const double t = random.real();
    const point on{wall.a.x + t * (wall.b.x - wall.a.x), wall.a.y + t * (wall.b.y - wall.a.y)};
    // Takes distances from about a rounding of the coordinates to a hundredth of the segment.
    double before = -1;
    for (int e = -40; e < 6; ++e) {
      const double step = std::ldexp(1, e);
      const point q{on.x - 2913.2 / 4000 * step, on.y + 2733.8 / 4000 * step};
      const double distance = distance_from(q, wall);
      CHECK(distance >= before);
      before = distance;
    }
  }
}

}  // namespace
