// SPDX-License-Identifier: MIT
//
// Writes words as lines, so that a picture needs no font and is the same on every machine.
#pragma once

#include <string_view>

#include "asterism/core/site.hpp"
#include "asterism/mesh/draw/canvas.hpp"

namespace asterism::internal {

// Returns the width of a text whose capitals are `height` high.
double text_width(std::string_view text, double height);

// Strokes a text in the current colour, from the left end of its base line. ASCII only: other bytes
// become question marks.
void draw_text(canvas& on, const point& at, double height, std::string_view text);

}  // namespace asterism::internal
