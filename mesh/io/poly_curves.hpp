// SPDX-License-Identifier: MIT
//
// Reads the curves of a .poly file: an extension of this program's. They come after the regions,
// whose line must be there then, and which Triangle and others read no further than.
//
//   curves <curves>
//   <number> arc <segment> <centre x> <centre y> ccw|cw    from the segment's first vertex
//   <number> circle <vertex> <centre x> <centre y> [marker]
//   <number> bezier <segment> <x1> <y1> <x2> <y2>          inner control points of a cubic
//   <number> spline <segment> <segment> ...                through the vertices of all
//
// A spline is a centripetal Catmull-Rom curve: a cubic for each segment, with a common tangent in
// each vertex between two; it is closed if the last segment ends where the first starts. Before an
// open end the first chord is continued straight by its length. It never makes a loop or a cusp
// between two vertices.
// Source: Yuksel, Schaefer, Keyser, "Parameterization and applications of Catmull-Rom curves",
// Computer-Aided Design 43 (2011).
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/io/text_scanner.hpp"

namespace asterism::internal {

// Reads the part after the regions into the domain, which has vertices and segments already. Curves
// are not divided yet; divide_curves checks them.
std::optional<error> read_poly_curves(text_scanner& source, domain& d);

}  // namespace asterism::internal
