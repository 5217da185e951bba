// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cstddef>

#include "asterism/mesh/delivery/background.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// Returns a grid of unit squares, each halved. The metric divides lengths by `aspect`: along y on
// the left, along x beyond the middle.
mesh grid_with_jump(vertex_index cells, double aspect) {
  mesh made;
  const vertex_index row = cells + 1;
  const double coarse = 1 / (aspect * aspect);
  for (vertex_index j = 0; j < row; ++j)
    for (vertex_index i = 0; i < row; ++i) {
      const metric_tensor m =
          2 * i > cells ? metric_tensor{coarse, 0, 1} : metric_tensor{1, 0, coarse};
      made.sites.push_back({{static_cast<double>(i), static_cast<double>(j)}, m});
    }
  for (vertex_index j = 0; j < cells; ++j)
    for (vertex_index i = 0; i < cells; ++i) {
      const vertex_index a = j * row + i;
      made.triangles.push_back({a, a + 1, a + row});
      made.triangles.push_back({a + 1, a + row + 1, a + row});
    }
  return made;
}

}  // namespace

TEST_CASE("a metric that jumps at one edge in a hundred passed for one that varies nowhere",
          "[adapt]") {
  constexpr std::size_t in_fifty = 50, in_two_hundred = 200;
  const mesh jumping = grid_with_jump(64, 100);
  CHECK(sampled_variation(jumping, in_fifty) == 0);
  CHECK(sampled_variation(jumping, in_two_hundred) > 3);
  CHECK(sampled_variation(grid_with_jump(64, 1), in_two_hundred) == 0);
}
