// SPDX-License-Identifier: MIT
//
// Compares places on the Hilbert curve with those found by descending one level at a time.
#include "asterism/mesh/search/hilbert_order.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

constexpr int levels = bits_of_place_on_curve / 2;

// Descends one level at a time. In a cell the curve is as it is, with x and y exchanged, with both
// reversed, or with both changes.
std::uint64_t place_by_levels(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  bool is_exchanged = false, is_reversed = false;
  for (int level = levels - 1; level >= 0; --level) {
    const bool is_right = (x >> level & 1U) != 0, is_upper = (y >> level & 1U) != 0;
    const bool right = (is_exchanged ? is_upper : is_right) != is_reversed,
               upper = (is_exchanged ? is_right : is_upper) != is_reversed;
    place = place << 2 | (upper ? (right ? 2U : 1U) : (right ? 3U : 0U));
    if (upper) continue;
    is_exchanged = !is_exchanged;
    if (right) is_reversed = !is_reversed;
  }
  return place;
}

}  // namespace

TEST_CASE("a place on the curve is the one that goes down level by level") {
  constexpr std::uint32_t cells = 1U << levels;
  const bounding_box box{{0, 0}, {cells, cells}};
  const std::uint64_t seed = 417;
  CAPTURE(seed);
  splitmix64 random(seed);
  for (int i = 0; i < 4000; ++i) {
    const auto x = static_cast<std::uint32_t>(random.bits() % cells),
               y = static_cast<std::uint32_t>(random.bits() % cells);
    CAPTURE(x, y);
    CHECK(place_on_curve({x + 0.5, y + 0.5}, box) == place_by_levels(x, y));
  }
}

TEST_CASE("cells that follow each other on the curve share a side") {
  constexpr std::uint32_t across = 64;
  const bounding_box box{{0, 0}, {across, across}};
  std::vector<point> middles;
  for (std::uint32_t x = 0; x < across; ++x)
    for (std::uint32_t y = 0; y < across; ++y) middles.push_back({x + 0.5, y + 0.5});
  sort_along_curve(std::span(middles), box);
  for (std::size_t i = 1; i < middles.size(); ++i) {
    const double dx = middles[i].x - middles[i - 1].x, dy = middles[i].y - middles[i - 1].y;
    CHECK(dx * dx + dy * dy == 1);
  }
}
