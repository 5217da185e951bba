// SPDX-License-Identifier: MIT
#include "asterism/mesh/gradation/gradation_grid.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace asterism;
using namespace asterism::internal;

namespace {

// A grid split at random, more often in one corner, so that deep cells are beside coarse ones.
gradation_grid random_grid(const bounding_box& box, int splits, std::uint64_t seed) {
  gradation_grid grid(box);
  std::mt19937_64 random(seed);
  for (int i = 0; i < splits; ++i) {
    const std::size_t count = grid.cells().size();
    auto c = static_cast<std::uint32_t>(i % 3 == 0 ? random() % count : count - 1 - random() % 4);
    while (!grid.cells()[c].leaf()) c = grid.cells()[c].children + random() % 4;
    grid.split(c);
  }
  return grid;
}

bool shares_an_edge(const gradation_grid::cell& a, const gradation_grid::cell& b) {
  const auto overlap = [](std::uint32_t p, std::uint32_t m, std::uint32_t q, std::uint32_t n) {
    return p < q + n && q < p + m;
  };
  const bool beside = a.x + a.side == b.x || b.x + b.side == a.x;
  const bool above = a.y + a.side == b.y || b.y + b.side == a.y;
  return (beside && overlap(a.y, a.side, b.y, b.side)) ||
         (above && overlap(a.x, a.side, b.x, b.side));
}

}  // namespace

TEST_CASE("leaves that share an edge differ by a factor of two at most") {
  const gradation_grid grid = random_grid({{0, 0}, {2, 1}}, 150, 1);
  std::size_t pairs = 0;
  for (const auto& a : grid.cells())
    for (const auto& b : grid.cells()) {
      if (!a.leaf() || !b.leaf() || !shares_an_edge(a, b)) continue;
      ++pairs;
      REQUIRE(a.side <= 2 * b.side);
    }
  REQUIRE(pairs > 1000);
}

TEST_CASE("what is linear is interpolated exactly, in every triangle") {
  for (const bounding_box& box :
       {bounding_box{{-1, -1}, {1, 1}}, {{3, -2}, {3.5, 5}}, {{0, 0}, {1, 1e-6}}}) {
    const gradation_grid grid = random_grid(box, 200, 2);
    const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
    std::mt19937_64 random(3);
    const auto uniform = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    for (int i = 0; i < 20000; ++i) {
      const point q{box.low.x + width * uniform(), box.low.y + height * uniform()};
      const auto place = grid.locate(q);
      double sum = 0, x = 0, y = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double w = place.weight[k];
        REQUIRE(w >= 0);
        sum += w;
        x += w * grid.position(place.node[k]).x;
        y += w * grid.position(place.node[k]).y;
      }
      REQUIRE(sum == Approx(1).epsilon(1e-14));
      REQUIRE(std::abs(x - q.x) <= 1e-12 * (width + std::abs(q.x)));
      REQUIRE(std::abs(y - q.y) <= 1e-12 * (height + std::abs(q.y)));
    }
  }
}

TEST_CASE("a node is interpolated by itself, and points outside like the nearest of the box") {
  const gradation_grid grid = random_grid({{-1, -1}, {1, 1}}, 100, 4);
  const auto weight_of = [&](std::uint32_t node, const point& q) {
    const auto place = grid.locate(q);
    double w = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (place.node[k] == node) w += place.weight[k];
    return w;
  };
  for (std::uint32_t n = 0; n < grid.nodes(); ++n) {
    const point& q = grid.position(n);
    REQUIRE(weight_of(n, q) == Approx(1).epsilon(1e-9));
    if (q.x == 1) REQUIRE(weight_of(n, {7, q.y}) == Approx(1).epsilon(1e-9));
    if (q.y == -1) REQUIRE(weight_of(n, {q.x, -1e300}) == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("a cell of the deepest level is not split") {
  gradation_grid grid({{0, 0}, {1, 1}});
  std::uint32_t c = 0;
  int splits = 0;
  while (grid.split(c)) {
    c = grid.cells()[c].children;
    REQUIRE(++splits < gradation_grid::deepest);
  }
  REQUIRE(grid.cells()[c].leaf());
  REQUIRE(splits == gradation_grid::deepest - 1);
}
