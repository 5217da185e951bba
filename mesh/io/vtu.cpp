// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include "asterism/mesh/numerics/metric_angle.hpp"

namespace asterism::internal {

namespace {

using text = std::back_insert_iterator<std::string>;

// Writes one array: `print(item)` for each item, then the end tag.
template <class Range, class Print>
void write_array(text out, std::string_view type, std::string_view name, int components,
                 const Range& items, const Print& print) {
  fmt::format_to(out, R"(<DataArray type="{}" Name="{}")", type, name);
  if (components > 1) fmt::format_to(out, R"( NumberOfComponents="{}")", components);
  fmt::format_to(out, " format=\"ascii\">\n");
  for (const auto& item : items) print(item);
  fmt::format_to(out, "</DataArray>\n");
}

std::vector<int> star_sizes(const mesh& m) {
  std::vector<int> sizes(m.sites.size(), 0);
  for (const triangle& t : m.triangles)
    for (const vertex_index v : t) ++sizes[v];
  return sizes;
}

void write_point_data(text out, const mesh& m) {
  fmt::format_to(out, "<PointData Tensors=\"metric_tensor\">\n");
  write_array(out, "Float64", "metric", 3, m.sites, [&](const site& s) {
    fmt::format_to(out, "{:.17g} {:.17g} {:.17g}\n", s.metric.m11, s.metric.m12, s.metric.m22);
  });
  write_array(out, "Float64", "metric_tensor", 9, m.sites, [&](const site& s) {
    fmt::format_to(out, "{0:.17g} {1:.17g} 0 {1:.17g} {2:.17g} 0 0 0 1\n", s.metric.m11,
                   s.metric.m12, s.metric.m22);
  });
  write_array(out, "Int32", "star_size", 1, star_sizes(m),
              [&](int size) { fmt::format_to(out, "{}\n", size); });
  std::vector<int> given(m.sites.size(), 0);
  for (std::size_t v = 0; v < m.given && v < given.size(); ++v) given[v] = 1;
  write_array(out, "Int32", "given", 1, given,
              [&](int is_given) { fmt::format_to(out, "{}\n", is_given); });
  fmt::format_to(out, "</PointData>\n");
}

void write_cell_data(text out, const mesh& m, const std::vector<triangle>& cells) {
  fmt::format_to(out, "<CellData Scalars=\"smallest_angle\">\n");
  write_array(out, "Float64", "smallest_angle", 1, cells,
              [&](const triangle& t) { fmt::format_to(out, "{:.17g}\n", smallest_angle(m, t)); });
  std::vector<int> disagreeing(cells.size(), 0);
  for (std::size_t i = m.triangles.size(); i < cells.size(); ++i) disagreeing[i] = 1;
  write_array(out, "Int32", "disagreeing", 1, disagreeing,
              [&](int flag) { fmt::format_to(out, "{}\n", flag); });
  std::vector<int> regions(m.triangles.size(), 1);
  if (!m.regions.empty()) regions = m.regions;
  regions.resize(cells.size(), 0);
  write_array(out, "Int32", "region", 1, regions,
              [&](int region) { fmt::format_to(out, "{}\n", region); });
  fmt::format_to(out, "</CellData>\n");
}

void write_cells(text out, const std::vector<triangle>& cells) {
  constexpr int vtk_triangle = 5;
  fmt::format_to(out, "<Cells>\n");
  write_array(out, "Int64", "connectivity", 1, cells,
              [&](const triangle& t) { fmt::format_to(out, "{} {} {}\n", t[0], t[1], t[2]); });
  std::size_t end = 0;
  write_array(out, "Int64", "offsets", 1, cells,
              [&](const triangle&) { fmt::format_to(out, "{}\n", end += 3); });
  write_array(out, "UInt8", "types", 1, cells,
              [&](const triangle&) { fmt::format_to(out, "{}\n", vtk_triangle); });
  fmt::format_to(out, "</Cells>\n");
}

}  // namespace

std::string vtu_text(const mesh& m) {
  std::vector<triangle> cells = m.triangles;
  cells.insert(cells.end(), m.disagreeing.begin(), m.disagreeing.end());
  // About what the text will take, in bytes: growing a string of megabytes takes three times as
  // much.
  constexpr std::size_t for_a_site = 256, for_a_cell = 64;
  std::string contents;
  contents.reserve(for_a_site * m.sites.size() + for_a_cell * cells.size());
  contents +=
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n";
  const text out(contents);
  fmt::format_to(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                 m.sites.size(), cells.size());
  write_array(out, "Float64", "Points", 3, m.sites, [&](const site& s) {
    fmt::format_to(out, "{:.17g} {:.17g} 0\n", s.position.x, s.position.y);
  });
  fmt::format_to(out, "</Points>\n");
  write_cells(out, cells);
  write_point_data(out, m);
  write_cell_data(out, m, cells);
  contents += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return contents;
}

}  // namespace asterism::internal
