// SPDX-License-Identifier: MIT
//
// Chooses the colours of a picture's triangles and boundary edges, and what its legend says of
// them. The colours are those of pages (mesh/draw/page/colours.js, fields.js).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/draw/canvas.hpp"
#include "asterism/mesh/draw/picture.hpp"

namespace asterism::internal {

// A legend: a bar of colours from one number to another, or boxes with names, or both.
struct picture_legend {
  std::string title, low, high;
  std::vector<colour> bar;  // from low to high; empty: none
  std::vector<std::pair<colour, std::string>> boxes;

  bool is_empty() const { return bar.empty() && boxes.empty(); }
};

struct picture_colouring {
  std::vector<colour> triangles;  // one for each of mesh::triangles; empty: they are not filled
  std::vector<colour> boundary;   // one for each boundary edge; empty: all are ink
  picture_legend legend;
};

// Fails for a field that has not one number for each site, and where what is to be shown is not
// there: colours of triangles of a mesh without any, of markers without boundary.
result<picture_colouring> colours_of(const mesh& m, const picture_options& options);

// Returns how high the legend is, 0 for none, of a picture of this width.
double legend_height(const picture_legend& legend, double width);

// Draws the legend with its upper left corner there, in the width.
void draw_legend(canvas& on, const picture_legend& legend, const point& corner, double width);

}  // namespace asterism::internal
