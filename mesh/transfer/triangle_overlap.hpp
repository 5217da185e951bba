// SPDX-License-Identifier: MIT
//
// Finds the common part of two triangles, by exact signs.
//
// The eighteen orientations of three corners each decide which corners and crossings the common
// part has, however degenerate; only places and weights are rounded. A crossing is the same, bit
// for bit, for all triangles that share the two edges, so that the parts of a triangle fit
// together.
#pragma once

#include <array>
#include <cstddef>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Corner of a common part: its place, and its barycentric weights in either triangle.
struct overlap_corner {
  point at;
  std::array<double, 3> in_old{}, in_new{};
};

// A convex polygon, counter-clockwise.
struct overlap {
  std::array<overlap_corner, 9> corners;
  std::size_t count = 0;  // less than 3: there is no common part
};

// A triangle with the numbers of its corners, so that crossings are computed alike from both sides.
struct numbered_triangle {
  triangle v{};
  std::array<point, 3> at;
};

// Orientations of the corners of each triangle against the edges of the other triangle. Edge i
// leads from corner i to the next.
struct overlap_signs {
  std::array<std::array<sign, 3>, 3> old_against{};  // [edge of the new one][corner of the old one]
  std::array<std::array<sign, 3>, 3> new_against{};  // [edge of the old one][corner of the new one]

  overlap_signs(const numbered_triangle& old_one, const numbered_triangle& new_one);
  // True if the common part extends across edge i of the old triangle.
  bool goes_on(std::size_t i) const;
};

// Returns the common part of two counter-clockwise triangles.
overlap common_part(const numbered_triangle& old_one, const numbered_triangle& new_one,
                    const overlap_signs& signs);

// Returns the barycentric weights of a point in a triangle, none negative, of sum one.
std::array<double, 3> weights_in(const std::array<point, 3>& corners, const point& q);

}  // namespace asterism::internal
