// SPDX-License-Identifier: MIT
//
// Makes the Utah teapot: 32 bicubic Bezier patches. Source: Martin Newell, 1975, in the proportions
// that James Blinn gave it; the four patches of the bottom are Frank Crow's, 1987.
#pragma once

#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// Rim, body, lid and bottom are turned profiles, a quarter a patch; handle and spout have halves.
// Neighbours have the same control points along a common side, bit for bit. The body is open where
// handle and spout end at it, and between lid and rim there is a gap. Triangles of a patch see its
// outside counter-clockwise.
surface teapot_surface();

}  // namespace asterism::internal
