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

// Place on the border of a trimmed patch of a given site: the curve, and the share of the curve's
// parameters, from 0 to below 1.
struct border_place {
  std::uint32_t curve = 0;
  double place = 0;
};

// The plane mesh of a patch, in the chart (u 2^scale_u, v 2^scale_v). Its first four sites are the
// corners of the patch, counter-clockwise from the least u and v; the other given sites lie on its
// sides. Of a trimmed patch the first sites are the starts of its curves, and the other given sites
// are points inside the curves; segments join successive sites of a curve.
struct shell_face {
  std::uint32_t patch = 0;
  int scale_u = 0, scale_v = 0;
  bool reversed = false;  // its triangles stand in the shell the other way round
  mesh plane;
  std::vector<std::uint32_t> vertex;      // of the shell, for each site
  std::vector<border_place> border = {};  // of the given sites of a trimmed patch
};

// The triangles of the shell are those of its faces in order, without those that have a vertex
// twice, which lie at a side of a patch that is one point.
struct surface_shell {
  std::vector<space_point> points;
  std::vector<shell_face> faces;
};

}  // namespace asterism::internal
