// SPDX-License-Identifier: MIT
//
// Draws the legend of a picture's colours below it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/draw/canvas.hpp"

namespace asterism::internal {

// A legend: a bar of colours from one number to another, or boxes with names, or both.
struct picture_legend {
  std::string title, low, high;
  std::vector<colour> bar;  // from low to high; empty: none
  std::vector<std::pair<colour, std::string>> boxes;

  bool is_empty() const { return bar.empty() && boxes.empty(); }
};

// Returns the height of the legend, 0 if there is none, for a picture of this width.
double legend_height(const picture_legend& legend, double width);

// Draws the legend with its upper left corner at this point, in this width.
void draw_legend(canvas& on, const picture_legend& legend, const point& corner, double width);

}  // namespace asterism::internal
