// SPDX-License-Identifier: MIT
//
// Makes the parts of a shell's triangles, each with the part of the surface that it was lifted
// from: a triangle of parameters in one Bezier piece, cut at knots exactly.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/mesh/surface_audit/deviation_scene.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"

namespace asterism::internal {

struct lifted_scene {
  const deviation_scene& space;           // with the triangles kept
  const std::vector<patch_spans>& spans;  // of each face's patch
  const std::vector<shell_triangle>& triangles;
};

struct lifted_cell {
  std::uint32_t triangle = 0, piece = 0;
  int depth = 0;
  bool is_cut = false;          // the triangle has several parts, as knots cut it
  parameter_triangle corners;   // in the piece
  std::uint32_t hint = 0;       // a triangle in space nearby
  double above = 0, below = 0;  // squared distances, or tangents
};

// All of these functions require a floating_point_scope(rounding::upward).

// Returns the parts of a triangle in the pieces that it reaches into; none where a corner of a part
// is so near to a crossing of knots that its side is not certain.
std::vector<lifted_cell> cells_of(const lifted_scene& scene, std::uint32_t triangle);
// Returns the net of the surface over the part.
triangle_net net_of(const lifted_scene& scene, const lifted_cell& cell);
// Returns the four parts into which the middles of its sides divide a part.
std::array<lifted_cell, 4> quarters(const lifted_cell& cell);

}  // namespace asterism::internal
