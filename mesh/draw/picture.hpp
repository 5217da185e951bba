// SPDX-License-Identifier: MIT
//
// Draws a mesh: one drawing for SVG, PDF and PNG.
//
// Triangles are drawn in thin lines, the boundary in a bold one, internal segments in between. A
// domain is a mesh without triangles (mesh/draw/outline.hpp). Where lines would hide most of the
// mesh, its triangles being a few pixels each, they are coloured by the most informative measure,
// unless the options name one, and triangles too small for lines have none. Disagreeing triangles
// are red, triangles with an angle below the bound tinted. Sites are dots with the given ones
// marked, but not on a mesh of more than 300. Unit circles of the metric are thinned out so that
// they stay readable, all drawn to one scale.
#pragma once

#include <optional>
#include <string>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/draw/picture_options.hpp"

namespace asterism {

// Returns the reason why no picture can be drawn, if there is one. Loads cairo's shared library, as
// the first drawing does.
ASTERISM_EXPORT std::optional<error> missing_for_pictures();

// Returns the bytes of the file. Fails for a width out of range, a mesh without extent or with
// numbers that are not finite, a height beyond 20000, colours of values that the mesh does not
// have, and when cairo does.
ASTERISM_EXPORT result<std::string> draw_picture(const mesh& m, picture_format format,
                                                 const picture_options& options = {});

}  // namespace asterism
