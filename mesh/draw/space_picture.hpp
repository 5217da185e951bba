// SPDX-License-Identifier: MIT
//
// Draws a mesh in space in the first view of its page: from above and the side, z up, each patch in
// a colour of its own, triangles shaded by their angle to the light.
//
// Draws triangles in the order of their middles, the farthest first, so that nearer ones hide what
// is behind them. Of long triangles that pass each other closely the farther may hide the nearer.
#pragma once

#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/space_mesh.hpp"
#include "asterism/mesh/draw/picture_options.hpp"

namespace asterism::internal {

// Returns the bytes of the file, `width` wide. Fails for a mesh without triangles or without
// extent, a width out of range, and where cairo does. Every index must be in range.
result<std::string> draw_space_picture(const space_mesh& m, picture_format format,
                                       int width = picture_options().width);

}  // namespace asterism::internal
