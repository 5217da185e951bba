// SPDX-License-Identifier: MIT
//
// Triangulates the part of a rectangle outside a mesh, so that every edge of the mesh has a
// triangle on both sides: if all triangles turn counter-clockwise and all edges match, none
// overlap, and that is checked without a search.
//
// Method: a sweep over the vertices of the boundary from left to right. Between two edges that the
// sweep line crosses, outside the domain, a chain of vertices is kept that bulges to the right and
// has no triangle to its right yet. A new vertex makes a triangle with each edge of the chain that
// is visible from it. O(n log n) for n vertices of the boundary. Exact: all decisions are
// orientations.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal::proof_detail {

// Returns the triangles outside, counter-clockwise, of vertices of the mesh and of the corners,
// which are numbered after these. The pieces of the boundary (except those inside) must bound the
// mesh with the domain on their left, meet in ends alone and lie strictly within the corners, which
// are those of a rectangle. Fails if these requirements do not hold.
result<std::vector<triangle>> triangulate_outside(const mesh& subject,
                                                  const std::array<point, 4>& corners);

}  // namespace asterism::internal::proof_detail
