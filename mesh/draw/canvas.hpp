// SPDX-License-Identifier: MIT
//
// Collects what is drawn on a cairo surface as the bytes of an SVG, PDF or PNG file. Works inside
// draw_picture.
#pragma once

#include <functional>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/draw/picture.hpp"

// cairo's cairo_t: programs that use this library need not have cairo's headers.
struct _cairo;  // NOLINT(bugprone-reserved-identifier)

namespace asterism::internal {

// Returns the bytes of a file of `width` by `height` (pixels or points) that `paint` has drawn on.
// A drawing always gives the same bytes: no dates, no counters of the process. Fails when cairo
// does.
result<std::string> paint_file(picture_format format, int width, int height,
                               const std::function<void(_cairo*)>& paint);

}  // namespace asterism::internal
