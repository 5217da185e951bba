// SPDX-License-Identifier: MIT
#include "asterism/mesh/search/box_index.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "asterism/core/random.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

bounding_box random_box(splitmix64& random, double wide, double high) {
  const double x = random.real(), y = random.real();
  return {{x, y}, {x + wide * random.real(), y + high * random.real()}};
}

std::set<std::uint32_t> visited(const box_index& index, const bounding_box& box) {
  std::set<std::uint32_t> found;
  index.visit(box, [&](std::uint32_t item) {
    CHECK(found.insert(item).second);
    return true;
  });
  return found;
}

TEST_CASE("boxes of every shape are found where they are, and only there", "[box_index]") {
  splitmix64 random(7);
  const std::vector<std::array<double, 2>> shapes = {
      {1, 1}, {0.01, 0.01}, {1e-4, 1}, {1, 1e-4}, {1e-9, 0.3}, {0.2, 0}, {0, 0}};
  box_index index({{0, 0}, {1, 1}});
  std::vector<bounding_box> boxes;
  std::vector<char> present;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto& [wide, high] = shapes[i % shapes.size()];
    boxes.push_back(random_box(random, wide, high));
    present.push_back(1);
    index.insert(i, boxes.back());
    if (i % 3 == 2) {  // removes one inserted before the cells around it were divided
      index.remove(i / 2, boxes[i / 2]);
      present[i / 2] = 0;
    }
  }
  for (int asked = 0; asked < 200; ++asked) {
    const bounding_box box = random_box(random, 0.02, asked % 2 == 0 ? 0.02 : 0);
    std::set<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (present[i] != 0 && boxes_meet(boxes[i], box)) expected.insert(i);
    CHECK(visited(index, box) == expected);
  }
}

}  // namespace
