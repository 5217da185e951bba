// SPDX-License-Identifier: MIT
//
// Triangulates what a mesh leaves of a rectangle around it, so that every edge of the mesh has a
// triangle on both sides: then whoever checks that all triangles turn counter-clockwise and all
// edges match has proved that none overlap, without a search.
//
// Method: a sweep over the vertices of the boundary from left to right. Between two edges that the
// sweep line crosses, where the domain is not, a chain of vertices is kept that bulges to the right
// and has no triangle before it. A new vertex gets a triangle with each edge of the chain that it
// sees. O(n log n) for n vertices of the boundary. Exact: all decisions are orientations.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal::proof_detail {

// Returns the triangles outside, of vertices of the mesh and, as numbers that follow these, of the
// corners, counter-clockwise. The pieces of the boundary (not those inside) must bound the mesh
// with the domain on their left and meet in ends alone, strictly within the corners, which are
// those of a rectangle. Fails where these requirements do not hold.
result<std::vector<triangle>> triangulate_outside(const mesh& subject,
                                                  const std::array<point, 4>& corners);

}  // namespace asterism::internal::proof_detail
