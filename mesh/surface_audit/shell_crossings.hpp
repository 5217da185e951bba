// SPDX-License-Identifier: MIT
//
// Decides exactly whether triangles in space cross or touch other than in the vertices and edges
// that they have in common by number.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "asterism/mesh/data/space_mesh.hpp"

namespace asterism::internal {

// Returns the first two triangles that cross or touch, in the order of their least first
// coordinates; none if the triangles make an embedded shell. A triangle without area that is
// crossed counts too. Compares the boxes of all pairs whose ranges of the first coordinate overlap,
// and tests the pairs whose boxes overlap.
std::optional<std::array<std::uint32_t, 2>> crossing_triangles(const space_mesh& m);

}  // namespace asterism::internal
