// SPDX-License-Identifier: MIT
//
// Draws a mesh in space as it is first seen on its page: from above and aside, z up, each patch in
// a colour of its own, triangles shaded by how they lie to the light.
//
// What is behind is hidden by what is drawn later: triangles are drawn from the farthest middle to
// the nearest. Where long triangles pass each other closely one may be drawn over a nearer one.
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
