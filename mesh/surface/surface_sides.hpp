// SPDX-License-Identifier: MIT
//
// Finds the sides of patches that are the same curve, bit for bit or by the names of trimming
// curves, and how the patches are oriented towards each other.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/surface/face_border.hpp"

namespace asterism::internal {

// A side of a patch, by its number in face_border.
struct patch_side {
  std::size_t patch = 0;
  int side = 0;
  bool backward = false;  // against the curve's first side
};

// A curve that is one side, or the common side of two patches.
struct side_curve {
  std::vector<patch_side> sides;
  bool is_point = false;
  bool is_trim = false;
};

struct side_graph {
  std::vector<side_curve> curves;
  std::vector<std::vector<std::size_t>> curve_of;  // by patch and side
  // Number of the vertex at each corner of each patch; corner k is where side k starts going
  // around.
  std::vector<std::vector<std::size_t>> corner_of;
  std::size_t corners = 0;
  std::vector<bool> reversed;  // patches to be seen from the other side
};

// Fails if three sides are one curve, or patches cannot be oriented consistently.
result<side_graph> graph_of_sides(const surface& s, const std::vector<face_border>& borders);

}  // namespace asterism::internal
