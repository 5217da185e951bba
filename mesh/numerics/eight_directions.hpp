// SPDX-License-Identifier: MIT
//
// Lists eight directions at equal angles, for searches and walks around a point.
#pragma once

#include <array>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Unit vectors, counter-clockwise from (1, 0), rounded.
inline constexpr std::array<point, 8> eight_directions = [] {
  constexpr double h = 0.70710678118654752;  // the root of a half
  return std::array<point, 8>{
      {{1, 0}, {h, h}, {0, 1}, {-h, h}, {-1, 0}, {-h, -h}, {0, -1}, {h, -h}}};
}();

}  // namespace asterism::internal
