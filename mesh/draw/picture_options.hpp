// SPDX-License-Identifier: MIT
//
// Holds the options of a mesh's picture, its format included.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/solution.hpp"

namespace asterism {

// The formats of pictures.
enum class picture_format { svg, pdf, png };

// Quantity that colours show. A legend below the picture has its values.
enum class picture_by {
  nothing,
  angle,   // the least of a triangle's nine, from the bound on
  aspect,  // longest edge over height
  size,    // root of the area
  region,
  marker,  // of boundary edges and internal segments
  field    // picture_options::field
};

// Options of a picture.
struct picture_options {
  int width = 1000;  // pixels (PNG), points (PDF, SVG); 16 to 20000; the height follows the mesh
  bool sites = true;
  bool ellipses = false;
  double angle_bound = 0;  // degrees; tints triangles below it as seen from one of their vertices
  std::vector<point> marks = {};  // places to ring in red
  picture_by colours = picture_by::nothing;
  solution_field field = {};  // a scalar, for picture_by::field
};

}  // namespace asterism
