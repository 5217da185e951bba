// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/poly_writer.hpp"

#include <fmt/format.h>

#include <iterator>

namespace asterism::internal {

std::string poly_text(const domain& d) {
  std::string text;
  const auto put = std::back_inserter(text);
  std::size_t number = 0;
  fmt::format_to(put, "{} 2 0 0\n", d.vertices.size());
  for (const point& p : d.vertices) fmt::format_to(put, "{} {} {}\n", ++number, p.x, p.y);
  fmt::format_to(put, "{} 1\n", d.segments.size());
  number = 0;
  for (const segment& s : d.segments)
    fmt::format_to(put, "{} {} {} {}\n", ++number, s.a + 1, s.b + 1, s.marker);
  fmt::format_to(put, "{}\n", d.holes.size());
  number = 0;
  for (const point& p : d.holes) fmt::format_to(put, "{} {} {}\n", ++number, p.x, p.y);
  fmt::format_to(put, "{}\n", d.regions.size());
  number = 0;
  for (const region_point& r : d.regions)
    fmt::format_to(put, "{} {} {} {}\n", ++number, r.at.x, r.at.y, r.number);
  return text;
}

}  // namespace asterism::internal
