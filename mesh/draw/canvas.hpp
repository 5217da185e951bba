// SPDX-License-Identifier: MIT
//
// Draws with cairo, and returns the drawing as the bytes of an SVG, PDF or PNG file. Works inside
// draw_picture.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/draw/picture_options.hpp"

// Declares cairo's cairo_t: programs that use this library need not have cairo's headers.
struct _cairo;  // NOLINT(bugprone-reserved-identifier)

namespace asterism::internal {

struct cairo_functions;

struct colour {
  double red, green, blue, alpha = 1;
};

inline constexpr colour paper{1, 1, 1};

inline constexpr int largest_extent = 20000;  // of a page, pixels or points
// Returns the fault of a page's width, or nothing.
std::optional<error> fault_of_width(int width);

// Draws on a page. Keeps a path, as cairo does: move_to and line_to extend it; fill and stroke draw
// and clear it. Lines have round ends and corners. Lengths are in pixels or points; y points
// downwards.
class canvas {
 public:
  canvas(const cairo_functions& cairo, _cairo* context);

  void use(const colour& c);
  void set_line_width(double width);
  // Sets whether a pixel at an edge has the colour of one side alone (true) or mixes both (false,
  // the default). With true, triangles smaller than pixels cover the paper without gaps.
  void set_hard_edges(bool hard);

  void begin_path();  // apart from what the path has
  void move_to(const point& p);
  void line_to(const point& p);
  void close_path();
  void add_circle(const point& centre, double radius);
  // Adds the ellipse with these semi-axes, the first of which lies at `angle` from the x-axis.
  void add_ellipse(const point& centre, double first, double second, double angle);

  void fill();
  void fill_and_keep();
  void stroke();
  void paint();  // everything

 private:
  const cairo_functions* cairo_;
  _cairo* context_;
};

// Returns the bytes of a file of `width` by `height` (pixels or points) that `paint` has drawn on.
// A drawing always gives the same bytes: no dates, no counters of the process. Fails when cairo is
// not there, or fails.
//
// Loads cairo when it is first called. Most runs draw nothing, and loading it takes a fifth of the
// time of the smallest ones.
result<std::string> paint_file(picture_format format, int width, int height,
                               const std::function<void(canvas&)>& paint);

}  // namespace asterism::internal
