// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <memory>
#include <new>
#include <string_view>

namespace asterism::internal {

namespace {

struct surface_deleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct context_deleter {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  // Called from C: nothing may be thrown through it.
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

cairo_surface_t* make_surface(picture_format format, int width, int height, std::string& bytes) {
  if (format == picture_format::svg)
    return cairo_svg_surface_create_for_stream(append, &bytes, width, height);
  if (format == picture_format::png)
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
  // cairo would write the time of day.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  return surface;
}

// cairo numbers the surfaces of a process and writes that number into the SVG.
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
                               const std::function<void(_cairo*)>& paint) {
  // Declared before the surface, which writes to it when it is destroyed.
  std::string bytes;
  const std::unique_ptr<cairo_surface_t, surface_deleter> surface(
      make_surface(format, width, height, bytes));
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  {
    const std::unique_ptr<cairo_t, context_deleter> context(cairo_create(surface.get()));
    paint(context.get());
    status = cairo_status(context.get());
  }
  if (status == CAIRO_STATUS_SUCCESS && format == picture_format::png)
    status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  cairo_surface_finish(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
  // A finished surface says so; that is no failure.
  if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
    return error{std::string("drawing failed: ") + cairo_status_to_string(status)};
  if (format == picture_format::svg) remove_surface_number(bytes);
  return bytes;
}

}  // namespace asterism::internal
