// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtu.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "asterism/mesh/draw/packed_arrays.hpp"
#include "asterism/mesh/io/text_lines.hpp"
#include "asterism/mesh/numerics/metric_angle.hpp"
#include "asterism/mesh/support/markup.hpp"

namespace asterism::internal {

namespace {

template <class Number>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

// Gives bytes that come in parts to a sink, as one text in base64.
class base64_encoder {
 public:
  explicit base64_encoder(const byte_sink& put) : put_(put) {}
  void add(std::string_view bytes) {
    held_ += bytes;
    const std::size_t whole = held_.size() / 3 * 3;
    put_(base64(std::string_view(held_).substr(0, whole)));
    held_.erase(0, whole);
  }
  void end() { put_(base64(held_)); }

 private:
  const byte_sink& put_;
  std::string held_;  // fewer than three bytes between calls
};

// Collects the tags, and the functions that make the bytes between them.
class vtu_writer {
 public:
  void add(std::string_view text) { tags_ += text; }

  // Adds an array of `count` numbers, number(i) each, behind the count of their bytes. Data that
  // `number` refers to must live until the file is written.
  template <class Number, class Make>
  void add_array(std::string_view name, int components, std::size_t count, const Make& number,
                 std::string_view more = {}) {
    tags_ += fmt::format(R"(<DataArray type="{}" Name="{}")", type_name<Number>(), name);
    if (components > 1) tags_ += fmt::format(R"( NumberOfComponents="{}")", components);
    tags_ += fmt::format("{} format=\"binary\">\n", more);
    arrays_.push_back(
        {std::exchange(tags_, "\n</DataArray>\n"), [count, number](const byte_sink& put) {
           std::string before;
           append(before, count * sizeof(Number), sizeof(std::uint64_t));
           put(before);
           make_lines(
               count, [&](std::size_t i, std::string& bytes) { append(bytes, Number{number(i)}); },
               put);
         }});
  }

  void write(const byte_sink& put) {
    for (const array& a : arrays_) {
      put(a.tags_before);
      base64_encoder encoder(put);
      a.numbers([&encoder](std::string_view bytes) { encoder.add(bytes); });
      encoder.end();
    }
    put(tags_ += "</VTKFile>\n");
  }

 private:
  static void append(std::string& bytes, std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
  }
  template <class Number>
  static void append(std::string& bytes, Number number) {
    if constexpr (std::is_same_v<Number, double>)
      append(bytes, std::bit_cast<std::uint64_t>(number), sizeof number);
    else
      append(bytes, static_cast<std::uint64_t>(number), sizeof number);
  }

  struct array {
    std::string tags_before;
    std::function<void(const byte_sink&)> numbers;
  };

  std::string tags_;  // after the last array
  std::vector<array> arrays_;
};

std::vector<std::int32_t> star_sizes(const mesh& m) {
  std::vector<std::int32_t> sizes(m.sites.size(), 0);
  for (const triangle& t : m.triangles)
    for (const vertex_index v : t) ++sizes[v];
  return sizes;
}

// Adds the triangles, and after them the disagreeing ones.
struct mesh_cells {
  const mesh& m;
  std::size_t size() const { return m.triangles.size() + m.disagreeing.size(); }
  bool is_disagreeing(std::size_t i) const { return i >= m.triangles.size(); }
  const triangle& operator[](std::size_t i) const {
    return is_disagreeing(i) ? m.disagreeing[i - m.triangles.size()] : m.triangles[i];
  }
};

// Adds the subsegments as field data, since cells of lines would need a value in all data of
// triangles: two points, the marker, and the segment.
void add_boundary(vtu_writer& out, const mesh& m) {
  if (m.boundary.empty()) return;
  constexpr std::size_t each = 4;
  out.add("<FieldData>\n");
  out.add_array<std::int64_t>(
      "boundary", each, each * m.boundary.size(),
      [&m](std::size_t i) {
        const boundary_edge& e = m.boundary[i / each];
        return std::array{std::int64_t{e.a}, std::int64_t{e.b}, std::int64_t{e.marker},
                          std::int64_t{e.segment}}[i % each];
      },
      fmt::format(" NumberOfTuples=\"{}\"", m.boundary.size()));
  out.add("</FieldData>\n");
}

void add_points(vtu_writer& out, const mesh& m) {
  out.add("<Points>\n");
  out.add_array<double>("Points", 3, 3 * m.sites.size(), [&m](std::size_t i) {
    const point& q = m.sites[i / 3].position;
    return std::array{q.x, q.y, 0.0}[i % 3];
  });
  out.add("</Points>\n");
}

// Gives vectors a third component of 0; tensors have three numbers, like the metric.
void add_field(vtu_writer& out, const solution_field& field, std::size_t vertices) {
  const std::size_t c = components_of(field.kind), width = c == 1 ? 1 : 3;
  out.add_array<double>(escaped_markup(field.name), static_cast<int>(width), width * vertices,
                        [&field, c, width](std::size_t i) {
                          return i % width < c ? field.values[i / width * c + i % width] : 0.0;
                        });
}

void add_metric(vtu_writer& out, const mesh& m) {
  out.add_array<double>("metric", 3, 3 * m.sites.size(), [&m](std::size_t i) {
    const auto& [m11, m12, m22] = m.sites[i / 3].metric;
    return std::array{m11, m12, m22}[i % 3];
  });
  out.add_array<double>("metric_tensor", 9, 9 * m.sites.size(), [&m](std::size_t i) {
    const auto& [m11, m12, m22] = m.sites[i / 9].metric;
    return std::array{m11, m12, 0.0, m12, m22, 0.0, 0.0, 0.0, 1.0}[i % 9];
  });
}

void add_point_data(vtu_writer& out, const mesh& m, const std::vector<std::int32_t>& stars,
                    const vtu_contents& values) {
  out.add(values.with_metric ? "<PointData Tensors=\"metric_tensor\">\n" : "<PointData>\n");
  if (values.with_metric) add_metric(out, m);
  if (values.fields != nullptr)
    for (const solution_field& field : values.fields->fields) add_field(out, field, m.sites.size());
  out.add_array<std::int32_t>("star_size", 1, m.sites.size(),
                              [&stars](std::size_t v) { return stars[v]; });
  out.add_array<std::int32_t>("given", 1, m.sites.size(),
                              [&m](std::size_t v) { return v < m.given ? 1 : 0; });
  out.add("</PointData>\n");
}

void add_cell_data(vtu_writer& out, const mesh_cells& cells, bool with_metric) {
  out.add(with_metric ? "<CellData Scalars=\"smallest_angle\">\n" : "<CellData>\n");
  if (with_metric)
    out.add_array<double>("smallest_angle", 1, cells.size(),
                          [cells](std::size_t i) { return smallest_angle(cells.m, cells[i]); });
  out.add_array<std::int32_t>("disagreeing", 1, cells.size(),
                              [cells](std::size_t i) { return cells.is_disagreeing(i) ? 1 : 0; });
  out.add_array<std::int32_t>("region", 1, cells.size(), [cells](std::size_t i) {
    if (cells.is_disagreeing(i)) return 0;
    return cells.m.regions.empty() ? 1 : static_cast<int>(cells.m.regions[i]);
  });
  out.add("</CellData>\n");
}

void add_cells(vtu_writer& out, const mesh_cells& cells, const side_node_mesh* nodes) {
  constexpr std::uint8_t vtk_triangle = 5, vtk_quadratic_triangle = 22;
  const std::size_t each = nodes == nullptr ? 3 : 6;
  const std::uint8_t type = nodes == nullptr ? vtk_triangle : vtk_quadratic_triangle;
  out.add("<Cells>\n");
  out.add_array<std::int64_t>(
      "connectivity", 1, each * cells.size(), [cells, nodes, each](std::size_t i) {
        const std::size_t cell = i / each, k = i % each;
        return std::int64_t{k < 3 ? cells[cell][k] : nodes->of_triangles[cell][k - 3]};
      });
  out.add_array<std::int64_t>("offsets", 1, cells.size(), [each](std::size_t i) {
    return static_cast<std::int64_t>(each * (i + 1));
  });
  out.add_array<std::uint8_t>("types", 1, cells.size(), [type](std::size_t) { return type; });
  out.add("</Cells>\n");
}

}  // namespace

void write_vtu(const mesh& m, const vtu_contents& values, const byte_sink& put) {
  const mesh_cells cells{m};
  const std::vector<std::int32_t> stars = star_sizes(m);
  vtu_writer out;
  out.add(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n");
  add_boundary(out, m);
  out.add(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", m.sites.size(),
                      cells.size()));
  add_points(out, m);
  add_cells(out, cells, values.nodes);
  add_point_data(out, m, stars, values);
  add_cell_data(out, cells, values.with_metric);
  out.add("</Piece>\n</UnstructuredGrid>\n");
  out.write(put);
}

}  // namespace asterism::internal
