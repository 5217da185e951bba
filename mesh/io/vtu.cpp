// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include "asterism/mesh/numerics/metric_angle.hpp"

namespace asterism::internal {

namespace {

template <class Number>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

// Collects the tags, and the bytes that they lead to, which come after all of them.
class vtu_writer {
 public:
  void add(std::string_view text) { tags_ += text; }

  // Adds an array: its tag has the place, among the bytes, of the count before its numbers.
  template <class Number>
  void add_array(std::string_view name, int components, const std::vector<Number>& numbers) {
    tags_ += fmt::format(R"(<DataArray type="{}" Name="{}")", type_name<Number>(), name);
    if (components > 1) tags_ += fmt::format(R"( NumberOfComponents="{}")", components);
    tags_ += fmt::format(" format=\"appended\" offset=\"{}\"/>\n", bytes_.size());
    append(std::uint64_t{numbers.size() * sizeof(Number)}, sizeof(std::uint64_t));
    for (const Number number : numbers) {
      if constexpr (std::is_same_v<Number, double>)
        append(std::bit_cast<std::uint64_t>(number), sizeof(double));
      else
        append(static_cast<std::uint64_t>(number), sizeof(Number));
    }
  }

  std::string file() {
    tags_ += "<AppendedData encoding=\"raw\">\n_";
    tags_ += bytes_;
    tags_ += "\n</AppendedData>\n</VTKFile>\n";
    return std::move(tags_);
  }

 private:
  void append(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i));
  }

  std::string tags_, bytes_;
};

std::vector<std::int32_t> star_sizes(const mesh& m) {
  std::vector<std::int32_t> sizes(m.sites.size(), 0);
  for (const triangle& t : m.triangles)
    for (const vertex_index v : t) ++sizes[v];
  return sizes;
}

void write_points(vtu_writer& out, const mesh& m) {
  std::vector<double> positions;
  positions.reserve(3 * m.sites.size());
  for (const site& s : m.sites) positions.insert(positions.end(), {s.position.x, s.position.y, 0});
  out.add("<Points>\n");
  out.add_array("Points", 3, positions);
  out.add("</Points>\n");
}

void write_point_data(vtu_writer& out, const mesh& m) {
  std::vector<double> metrics, tensors;
  for (const site& s : m.sites) {
    const auto& [m11, m12, m22] = s.metric;
    metrics.insert(metrics.end(), {m11, m12, m22});
    tensors.insert(tensors.end(), {m11, m12, 0, m12, m22, 0, 0, 0, 1});
  }
  std::vector<std::int32_t> given(m.sites.size(), 0);
  for (std::size_t v = 0; v < m.given && v < given.size(); ++v) given[v] = 1;
  out.add("<PointData Tensors=\"metric_tensor\">\n");
  out.add_array("metric", 3, metrics);
  out.add_array("metric_tensor", 9, tensors);
  out.add_array("star_size", 1, star_sizes(m));
  out.add_array("given", 1, given);
  out.add("</PointData>\n");
}

void write_cell_data(vtu_writer& out, const mesh& m, const std::vector<triangle>& cells) {
  std::vector<double> angles;
  angles.reserve(cells.size());
  for (const triangle& t : cells) angles.push_back(smallest_angle(m, t));
  std::vector<std::int32_t> disagreeing(cells.size(), 0), regions(m.triangles.size(), 1);
  for (std::size_t i = m.triangles.size(); i < cells.size(); ++i) disagreeing[i] = 1;
  if (!m.regions.empty()) regions.assign(m.regions.begin(), m.regions.end());
  regions.resize(cells.size(), 0);
  out.add("<CellData Scalars=\"smallest_angle\">\n");
  out.add_array("smallest_angle", 1, angles);
  out.add_array("disagreeing", 1, disagreeing);
  out.add_array("region", 1, regions);
  out.add("</CellData>\n");
}

void write_cells(vtu_writer& out, const std::vector<triangle>& cells) {
  constexpr std::uint8_t vtk_triangle = 5;
  std::vector<std::int64_t> corners, ends;
  for (const triangle& t : cells) {
    corners.insert(corners.end(), t.begin(), t.end());
    ends.push_back(static_cast<std::int64_t>(corners.size()));
  }
  out.add("<Cells>\n");
  out.add_array("connectivity", 1, corners);
  out.add_array("offsets", 1, ends);
  out.add_array("types", 1, std::vector<std::uint8_t>(cells.size(), vtk_triangle));
  out.add("</Cells>\n");
}

}  // namespace

std::string vtu_bytes(const mesh& m) {
  std::vector<triangle> cells = m.triangles;
  cells.insert(cells.end(), m.disagreeing.begin(), m.disagreeing.end());
  vtu_writer out;
  out.add(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n");
  out.add(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", m.sites.size(),
                      cells.size()));
  write_points(out, m);
  write_cells(out, cells);
  write_point_data(out, m);
  write_cell_data(out, m, cells);
  out.add("</Piece>\n</UnstructuredGrid>\n");
  return out.file();
}

}  // namespace asterism::internal
