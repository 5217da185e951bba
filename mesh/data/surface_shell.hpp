// SPDX-License-Identifier: MIT
//
// Holds a mesh of a surface: a shell of triangles in space, and for each patch the plane mesh that
// it was lifted from.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// The plane mesh of a patch, in the chart (u 2^scale_u, v 2^scale_v). Its first four sites are the
// corners of the patch, counter-clockwise from the least u and v; the rest of those given lie on
// its sides.
struct shell_face {
  std::uint32_t patch = 0;
  int scale_u = 0, scale_v = 0;
  bool reversed = false;  // its triangles stand in the shell the other way round
  mesh plane;
  std::vector<std::uint32_t> vertex;  // of the shell, for each site
};

// The triangles of the shell are those of its faces in order, without those that have a vertex
// twice: such lie at a side of a patch that is one point.
struct surface_shell {
  std::vector<space_point> points;
  std::vector<shell_face> faces;
};

}  // namespace asterism::internal
