// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/canvas.hpp"

#include <memory>
#include <new>
#include <numbers>
#include <string_view>

#include "asterism/mesh/draw/cairo_functions.hpp"

namespace asterism::internal {

std::optional<error> fault_of_width(int width) {
  if (width >= 16 && width <= largest_extent) return {};
  return error{"a picture is 16 to 20000 wide, not " + std::to_string(width),
               error_code::bad_option};
}

canvas::canvas(const cairo_functions& cairo, _cairo* context) : cairo_(&cairo), context_(context) {
  cairo.set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo.set_line_cap(context, CAIRO_LINE_CAP_ROUND);
}

void canvas::use(const colour& c) {
  cairo_->set_source_rgba(context_, c.red, c.green, c.blue, c.alpha);
}

void canvas::set_line_width(double width) { cairo_->set_line_width(context_, width); }

void canvas::set_hard_edges(bool hard) {
  cairo_->set_antialias(context_, hard ? CAIRO_ANTIALIAS_NONE : CAIRO_ANTIALIAS_DEFAULT);
}

void canvas::begin_path() { cairo_->new_sub_path(context_); }

void canvas::move_to(const point& p) { cairo_->move_to(context_, p.x, p.y); }

void canvas::line_to(const point& p) { cairo_->line_to(context_, p.x, p.y); }

void canvas::close_path() { cairo_->close_path(context_); }

void canvas::add_circle(const point& centre, double radius) {
  cairo_->new_sub_path(context_);
  cairo_->arc(context_, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
}

void canvas::add_ellipse(const point& centre, double first, double second, double angle) {
  cairo_->save(context_);
  cairo_->translate(context_, centre.x, centre.y);
  cairo_->rotate(context_, angle);
  cairo_->scale(context_, first, second);
  add_circle({0, 0}, 1);
  cairo_->restore(context_);
}

void canvas::fill() { cairo_->fill(context_); }

void canvas::fill_and_keep() { cairo_->fill_preserve(context_); }

void canvas::stroke() { cairo_->stroke(context_); }

void canvas::paint() { cairo_->paint(context_); }

namespace {

using surface = std::unique_ptr<cairo_surface_t, decltype(&::cairo_surface_destroy)>;
using context = std::unique_ptr<cairo_t, decltype(&::cairo_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  // Catches exceptions, since cairo calls this from C.
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

cairo_surface_t* make_surface(const cairo_functions& cairo, picture_format format, int width,
                              int height, std::string& bytes) {
  if (format == picture_format::svg)
    return cairo.svg_surface_create_for_stream(append, &bytes, width, height);
  if (format == picture_format::png)
    return cairo.image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  cairo_surface_t* pdf = cairo.pdf_surface_create_for_stream(append, &bytes, width, height);
  // Sets a fixed date, in place of the time of day that cairo would write.
  cairo.pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  return pdf;
}

// Removes the number from names in the SVG: cairo counts the surfaces of a process.
void remove_surface_number(std::string& svg) {
  constexpr std::string_view mark = "id=\"surface";
  const std::size_t begin = svg.find(mark);
  if (begin == std::string::npos) return;
  const std::size_t digits = begin + mark.size();
  const std::size_t end = svg.find('"', digits);
  if (end != std::string::npos) svg.erase(digits, end - digits);
}

}  // namespace

result<std::string> paint_file(picture_format format, int width, int height,
                               const std::function<void(canvas&)>& paint) {
  const auto library = load_cairo();
  if (!library.ok()) return library.failure();
  const cairo_functions& cairo = *library.value();
  // Declares the bytes before the surface, which writes to them when it is destroyed.
  std::string bytes;
  const surface file(make_surface(cairo, format, width, height, bytes), cairo.surface_destroy);
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    const context drawing(cairo.create(file.get()), cairo.destroy);
    canvas on(cairo, drawing.get());
    paint(on);
    status = cairo.status(drawing.get());
  }
  if (status == CAIRO_STATUS_SUCCESS && format == picture_format::png)
    status = cairo.surface_write_to_png_stream(file.get(), append, &bytes);
  cairo.surface_finish(file.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo.surface_status(file.get());
  // Accepts the status of a finished surface, which is no failure.
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
    return error{std::string("drawing failed: ") + cairo.status_to_string(status)};
  if (format == picture_format::svg) remove_surface_number(bytes);
  return bytes;
}

}  // namespace asterism::internal
