// SPDX-License-Identifier: MIT
//
// Lists the triangles of a shell, with the place of each in its patch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/mesh/data/space_mesh.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface_audit/bezier_pieces.hpp"
#include "asterism/mesh/surface_audit/surface_locator.hpp"

namespace asterism::internal {

// Pieces of each patch, in the order of its spans: the pieces of one span of u, along v, are next
// to each other.
struct patch_spans {
  std::uint32_t first = 0;   // of its pieces
  std::vector<double> u, v;  // ends of the spans, ascending
};
std::vector<patch_spans> spans_of(const std::vector<bezier_piece>& pieces, std::size_t patches);
// Returns the piece of a patch that contains (u, v), and the place in it, rounded.
surface_place place_in(const std::vector<bezier_piece>& pieces, const patch_spans& spans, double u,
                       double v);

struct shell_triangle {
  std::uint32_t face = 0;
  std::array<std::uint32_t, 3> vertex{};      // of the shell, as the plane has them
  std::array<std::array<double, 2>, 3> at{};  // u and v of the corners
  std::uint32_t kept = 0;                     // its number among those in space
  bool collapsed = false;                     // a vertex twice: it is none in space
};

// Lists the triangles. Requires that every index is in range.
std::vector<shell_triangle> triangles_of(const surface_shell& shell);

// Returns the triangles in space, with their corners in the order of the face, or in the opposite
// order if the face is reversed.
space_mesh mesh_of(const surface_shell& shell, const std::vector<shell_triangle>& triangles);

}  // namespace asterism::internal
