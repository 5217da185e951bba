// SPDX-License-Identifier: MIT
//
// Finds which sides of patches are the same curve, bit for bit or by the names of trimming curves,
// and how the patches are turned towards each other.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface/face_border.hpp"

namespace asterism::internal {

// A side by its number in face_border.
struct patch_side {
  std::size_t patch = 0;
  int side = 0;
  bool backward = false;  // against the curve's first side
};

// A curve of one side, or of two.
struct side_curve {
  std::vector<patch_side> sides;
  bool is_point = false;
  bool is_trim = false;
};

struct side_graph {
  std::vector<side_curve> curves;
  std::vector<std::vector<std::size_t>> curve_of;  // by patch and side
  // The number of the vertex that each corner is; corner k is where side k starts going around.
  std::vector<std::vector<std::size_t>> corner_of;
  std::size_t corners = 0;
  std::vector<bool> reversed;  // patches to be seen from the other side
};

// Fails where three sides are one curve, or patches cannot all be seen from one side.
result<side_graph> graph_of_sides(const surface& s, const std::vector<face_border>& borders);

}  // namespace asterism::internal
