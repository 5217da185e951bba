// SPDX-License-Identifier: MIT
//
// Finds inner edges that join two vertices of the boundary. If values are prescribed on the
// boundary, a linear element has no free value on such an edge, nor in a triangle with three
// boundary vertices.
#pragma once

#include <array>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns the edges with triangles on both sides, each with the lesser vertex first, whose ends are
// both ends of edges with a triangle on one side alone; ascending. Lines inside are no boundary,
// and may be such edges. Where there is none, no triangle has all three vertices on the boundary,
// but for one that is a part of the mesh by itself. O(n log n).
std::vector<std::array<vertex_index, 2>> edges_across(const mesh& m);

}  // namespace asterism::internal
