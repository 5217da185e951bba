// SPDX-License-Identifier: MIT
//
// A mesh as a figure: one drawing for SVG, PDF and PNG.
//
// Triangles in thin lines, the boundary in a bold one, internal segments in
// between, disagreeing triangles filled red, triangles
// with an angle below the bound tinted, sites as dots with the given ones marked, and the unit
// circles of the metric, thinned out so that they stay readable and all drawn to one scale.
#pragma once

#include <string>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// The formats of pictures.
enum class picture_format { svg, pdf, png };

// Options of a picture.
struct picture_options {
  int width = 1000;  // pixels (PNG), points (PDF, SVG); 16 to 20000; the height follows the mesh
  bool sites = true;
  bool ellipses = false;
  double angle_bound = 0;  // degrees; tints triangles below it as seen from one of their vertices
};

// The bytes of the file. Fails for a width out of range, a mesh without extent or with numbers that
// are not finite, a height beyond 20000, and when cairo does.
ASTERISM_EXPORT result<std::string> draw_picture(const mesh& m, picture_format format,
                                                 const picture_options& options = {});

}  // namespace asterism
