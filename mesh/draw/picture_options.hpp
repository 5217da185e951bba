// SPDX-License-Identifier: MIT
//
// Holds what a picture of a mesh is to show, and in which format.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"

namespace asterism {

// The formats of pictures.
enum class picture_format { svg, pdf, png };

// Options of a picture.
struct picture_options {
  int width = 1000;  // pixels (PNG), points (PDF, SVG); 16 to 20000; the height follows the mesh
  bool sites = true;
  bool ellipses = false;
  double angle_bound = 0;  // degrees; tints triangles below it as seen from one of their vertices
  std::vector<point> marks = {};  // places to ring in red
};

}  // namespace asterism
