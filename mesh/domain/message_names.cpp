// SPDX-License-Identifier: MIT
#include "asterism/mesh/domain/message_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace asterism::internal {

namespace {

std::string place(const std::string& name, const std::string& file,
                  const std::vector<std::size_t>& lines, std::size_t item) {
  if (item < lines.size()) return fmt::format("{}:{}: ", file, lines[item]);
  const std::string& known = file.empty() ? name : file;
  return known.empty() ? std::string() : known + ": ";
}

// Returns the number of the first polygon with this segment; past the last one if there is none.
std::size_t polygon_with(const domain& d, std::size_t s) {
  std::size_t p = 0;
  for (; p < d.polygons.size(); ++p)
    for (const auto& ring : d.polygons[p].rings)
      if (std::find(ring.begin(), ring.end(), s) != ring.end()) return p;
  return p;
}

}  // namespace

std::string coordinates(const point& p) { return fmt::format("({}, {})", p.x, p.y); }

std::string domain_names::vertex(std::size_t v) const {
  return fmt::format("vertex {} {}", static_cast<long long>(v) + d_.origin.first_number,
                     coordinates(d_.vertices[v]));
}

std::string domain_names::segment(std::size_t s) const {
  if (const std::size_t p = polygon_with(d_, s); p < d_.polygons.size())
    return fmt::format("the side {} - {} of {}", coordinates(d_.vertices[d_.segments[s].a]),
                       coordinates(d_.vertices[d_.segments[s].b]), polygon(p));
  const long long first = d_.origin.first_number;
  return fmt::format("segment {} (vertices {}-{})", static_cast<long long>(s) + first,
                     d_.segments[s].a + first, d_.segments[s].b + first);
}

std::string domain_names::polygon(std::size_t p) const {
  const auto region = d_.polygons[p].region;
  return fmt::format("polygon {}", p + 1) +
         (region ? fmt::format(" (feature {})", *region) : std::string());
}

std::string domain_names::ring(std::size_t p, std::size_t r) const {
  return fmt::format("ring {} of ", r + 1) + polygon(p);
}

std::string domain_names::feature(const std::optional<int>& region) const {
  return region ? fmt::format("feature {}", *region) : "a polygon of no feature";
}

std::string domain_names::hole(std::size_t h) const {
  return fmt::format("hole {} {}", static_cast<long long>(h) + d_.origin.first_number,
                     coordinates(d_.holes[h]));
}

std::string domain_names::region(std::size_t r) const {
  return fmt::format("region {} {}", static_cast<long long>(r) + d_.origin.first_number,
                     coordinates(d_.regions[r].at));
}

std::string domain_names::curve(std::size_t c) const {
  const auto& numbers = d_.origin.curve_numbers;
  return fmt::format("curve {}", c < numbers.size() ? numbers[c] : c + 1);
}

std::string domain_names::at_vertex(std::size_t v) const {
  return place(d_.name, d_.origin.vertex_file, d_.origin.vertex_lines, v);
}

std::string domain_names::at_segment(std::size_t s) const {
  return place(d_.name, d_.origin.file, d_.origin.segment_lines, s);
}

std::string domain_names::at_hole(std::size_t h) const {
  return place(d_.name, d_.origin.file, d_.origin.hole_lines, h);
}

std::string domain_names::at_region(std::size_t r) const {
  return place(d_.name, d_.origin.file, d_.origin.region_lines, r);
}

std::string domain_names::at_curve(std::size_t c) const {
  return place(d_.name, d_.origin.file, d_.origin.curve_lines, c);
}

std::string domain_names::at_start() const { return place(d_.name, d_.origin.file, {}, 0); }

std::string domain_names::line_of_segment(std::size_t s) const {
  const auto& lines = d_.origin.segment_lines;
  return s < lines.size() ? fmt::format(" on line {}", lines[s]) : std::string();
}

}  // namespace asterism::internal
