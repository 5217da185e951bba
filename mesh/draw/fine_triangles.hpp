// SPDX-License-Identifier: MIT
//
// Finds the triangles of a mesh that are too small for a picture's lines.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns a flag for each of mesh::triangles: whether lines along its edges would hide it, because
// its inscribed circle has a diameter of less than two line widths. At two line widths a quarter of
// the triangle stays visible. `line_width` is in the mesh's own lengths.
std::vector<bool> hidden_by_lines(const mesh& m, double line_width);

// True if the triangles with a flag are more than half of the area.
bool are_most(const mesh& m, const std::vector<bool>& of_triangles);

}  // namespace asterism::internal
