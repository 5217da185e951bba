// SPDX-License-Identifier: MIT
//
// Calls cairo's functions, from its shared library, which is loaded at the first call.
#pragma once

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <string>

#include "asterism/core/result.hpp"

// Lists the functions that are used, without their common prefix `cairo_`.
// clang-format off
#define ASTERISM_CAIRO_FUNCTIONS(apply)                                                           \
  apply(arc) apply(close_path) apply(create) apply(destroy) apply(fill) apply(fill_preserve)      \
  apply(image_surface_create) apply(line_to) apply(move_to) apply(new_sub_path) apply(paint)      \
  apply(pdf_surface_create_for_stream) apply(pdf_surface_set_metadata) apply(restore)             \
  apply(rotate) apply(save) apply(scale) apply(set_antialias) apply(set_line_cap)                 \
  apply(set_line_join) apply(set_line_width) apply(set_source_rgba) apply(status)                 \
  apply(status_to_string) apply(stroke) apply(surface_destroy) apply(surface_finish)              \
  apply(surface_status) apply(surface_write_to_png_stream) apply(svg_surface_create_for_stream)   \
  apply(translate)
// clang-format on

namespace asterism::internal {

struct cairo_functions {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared has none
#define ASTERISM_DECLARE(name) decltype(&::cairo_##name) name = nullptr;
  ASTERISM_CAIRO_FUNCTIONS(ASTERISM_DECLARE)
#undef ASTERISM_DECLARE
};

// Returns cairo's functions. Fails, each time, if the library cannot be loaded or lacks one.
result<const cairo_functions*> load_cairo();

}  // namespace asterism::internal
