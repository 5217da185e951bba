// SPDX-License-Identifier: MIT
//
// Searches for the nearest place of a surface, and finds it beside a pole.
#include "asterism/mesh/surface_audit/surface_locator.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/core/random.hpp"
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

// Returns the unit sphere as one NURBS patch: meridians of two arcs, rotated about z by four arcs.
surface ball() {
  const double root = std::sqrt(0.5);
  const std::array<std::array<double, 3>, 5> half = {
      {{0, -1, 1}, {1, -1, root}, {1, 0, 1}, {1, 1, root}, {0, 1, 1}}};  // radius, z, weight
  const std::array<std::array<double, 3>, 9> turn = {{{1, 0, 1},
                                                      {1, 1, root},
                                                      {0, 1, 1},
                                                      {-1, 1, root},
                                                      {-1, 0, 1},
                                                      {-1, -1, root},
                                                      {0, -1, 1},
                                                      {1, -1, root},
                                                      {1, 0, 1}}};  // x, y, weight
  surface_patch patch{
      "ball", 2, 2, 9, 5, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {0, 0, 0, 1, 1, 2, 2, 2}, {}};
  for (const auto& t : turn)
    for (const auto& h : half)
      patch.control.push_back({{h[0] * t[0], h[0] * t[1], h[1]}, h[2] * t[2]});
  return {"ball", {patch}};
}

}  // namespace

TEST_CASE("the nearest place of a ball is found beside its poles") {
  const auto pieces = bezier_pieces(ball());
  REQUIRE(pieces);
  const surface_locator locator(pieces.value());
  splitmix64 random(71);
  for (int k = 0; k < 4000; ++k) {
    const double x = random.real(-0.3, 0.3), y = random.real(-0.3, 0.3);
    const double z = random.real(-1.1, -0.9);
    const plain_vector p{x, y, k % 2 == 0 ? z : -z};
    const double gap = std::sqrt(dot(p, p)) - 1;
    INFO(k << ": " << p.x << ' ' << p.y << ' ' << p.z);
    CHECK(std::sqrt(locator.nearest(p).squared_distance) <= std::abs(gap) + 1e-6);
  }
}
