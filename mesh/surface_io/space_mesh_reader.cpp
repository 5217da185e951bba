// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_io/space_mesh_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/text_scanner.hpp"
#include "asterism/mesh/io/vtu_file.hpp"
#include "asterism/mesh/surface_io/space_formats.hpp"
#include "asterism/mesh/surface_io/space_gmsh.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

constexpr int dimension_words = 3;

failure read_point(text_scanner& from, space_mesh& to) {
  space_point p;
  for (double* const x : {&p.x, &p.y, &p.z}) {
    const auto number = to_number(from, from.next(), "a coordinate");
    if (!number) return number.failure();
    *x = number.value();
  }
  to.points.push_back(p);
  return {};
}

failure read_vertex(text_scanner& from, const space_mesh& to, std::uint32_t& v) {
  const word w = from.next();
  const auto number = to_integer(from, w, "a vertex");
  if (!number) return number.failure();
  if (number.value() < 1 || number.value() > static_cast<long long>(to.points.size()))
    return from.failure(w.line, fmt::format("vertex {} does not exist; there are {}",
                                            number.value(), to.points.size()));
  v = static_cast<std::uint32_t>(number.value() - 1);
  return {};
}

// Returns the number of words in a record of a skipped section; 0 if it is not known.
std::size_t words_of(std::string_view section) {
  if (section == "Edges") return 3;
  if (section == "Corners" || section == "Ridges" || section == "RequiredVertices" ||
      section == "RequiredEdges")
    return 1;
  if (section == "Normals" || section == "Tangents") return dimension_words;
  if (section == "NormalAtVertices" || section == "TangentAtVertices") return 2;
  return 0;
}

class medit_space_reader {
 public:
  explicit medit_space_reader(text_scanner& from) : from_(from) {}

  failure read() {
    while (true) {
      const word head = from_.next();
      if (head.empty() || head.text == "End") return {};
      if (auto wrong = read_section(head)) return wrong;
    }
  }
  space_mesh made;

 private:
  failure read_section(const word& head) {
    if (head.text == "MeshVersionFormatted") return read_version();
    if (head.text == "Dimension") return read_dimension();
    const auto count = to_count(from_, from_.next(), "a number of records");
    if (!count) return count.failure();
    if (head.text == "Vertices") return read_vertices(count.value());
    if (head.text == "Triangles") return read_triangles(count.value());
    const std::size_t words = words_of(head.text);
    if (words == 0 && count.value() > 0)
      return from_.failure(head.line, quoted_token(head.text) +
                                          ": only triangles can be read, with what belongs to a "
                                          "surface's vertices and edges");
    for (std::size_t k = 0; k < words * count.value(); ++k) from_.next();
    return {};
  }
  failure read_version() {
    const auto version = to_integer(from_, from_.next(), "a version");
    if (!version) return version.failure();
    return {};
  }
  failure read_dimension() {
    const word w = from_.next();
    if (w.text == "3") return {};
    return from_.failure(
        w.line, "dimension " + quoted_token(w.text) + ", not 3: a mesh in space is wanted");
  }
  failure read_vertices(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      if (auto wrong = read_point(from_, made)) return wrong;
      from_.next();
    }
    return {};
  }
  failure read_triangles(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      space_triangle t{};
      for (std::uint32_t& v : t)
        if (auto wrong = read_vertex(from_, made, v)) return wrong;
      made.triangles.push_back(t);
      const word w = from_.next();
      const auto reference = to_marker(from_, w, "a reference");
      if (!reference) return reference.failure();
      made.faces.push_back(static_cast<std::uint32_t>(reference.value()));
    }
    return {};
  }

  text_scanner& from_;
};

}  // namespace

result<space_mesh> parse_space_medit(std::string_view text, const std::string& file) {
  text_scanner from(file, text);
  medit_space_reader reader(from);
  if (auto wrong = reader.read()) return *wrong;
  return std::move(reader.made);
}

result<space_mesh> parse_space_vtu(std::string_view text, const std::string& file) {
  auto opened = vtu_file::open(text, file);
  if (!opened) return opened.failure();
  vtu_file& from = opened.value();
  const vtu_array* const points = from.find("Points");
  const vtu_array* const connectivity = from.find("Cells", "connectivity");
  const vtu_array* const offsets_of = from.find("Cells", "offsets");
  const vtu_array* const types_of = from.find("Cells", "types");
  if (points == nullptr || connectivity == nullptr || offsets_of == nullptr || types_of == nullptr)
    return from.failure(from.piece_line(), "Points, connectivity, offsets and types are wanted");
  const auto width = from.components(*points);
  if (!width) return width.failure();
  if (width.value() != dimension_words)
    return from.failure(points->tag.line, "points of three coordinates are wanted");
  const auto at = from.numbers(*points, dimension_words * from.points());
  if (!at) return at.failure();
  const auto offsets = from.numbers(*offsets_of, from.cells());
  if (!offsets) return offsets.failure();
  const auto types = from.numbers(*types_of, from.cells());
  if (!types) return types.failure();
  const double corners_count = from.cells() == 0 ? 0 : offsets.value().back();
  if (!(corners_count >= 0 && corners_count <= static_cast<double>(text.size())))
    return from.failure(offsets_of->tag.line, "the last offset is out of range");
  const auto corners = from.numbers(*connectivity, static_cast<std::size_t>(corners_count));
  if (!corners) return corners.failure();
  space_mesh made;
  for (std::size_t v = 0; v < from.points(); ++v)
    made.points.push_back({at.value()[3 * v], at.value()[3 * v + 1], at.value()[3 * v + 2]});
  double begin = 0;
  for (std::size_t k = 0; k < from.cells(); ++k) {
    const double end = offsets.value()[k], type = types.value()[k];
    if (!(end >= begin && end <= corners_count))
      return from.failure(offsets_of->tag.line, fmt::format("offset {} descends", k + 1));
    if (type == 5 && end - begin == 3) {
      space_triangle t{};
      for (std::size_t i = 0; i < 3; ++i) {
        const double v = corners.value()[static_cast<std::size_t>(begin) + i];
        if (!(v >= 0 && v < static_cast<double>(made.points.size())))
          return from.failure(connectivity->tag.line,
                              fmt::format("point {:.0f}, from 0, does not exist; there are {}", v,
                                          made.points.size()));
        t[i] = static_cast<std::uint32_t>(v);
      }
      made.triangles.push_back(t);
    } else if (type != 1 && type != 3) {
      return from.failure(types_of->tag.line,
                          fmt::format("cell {} is of type {:g}: triangles (5), lines (3) and "
                                      "points (1) can be read",
                                      k + 1, type));
    }
    begin = end;
  }
  return made;
}

bool is_space_mesh_file(std::string_view name) {
  for (const char* const ending : {".obj", ".stl", ".ply", ".mesh", ".msh", ".vtu"})
    if (has_ending(name, ending)) return true;
  return false;
}

result<space_mesh> read_space_mesh(const std::filesystem::path& path) {
  const std::string file = path.string();
  if (!is_space_mesh_file(file))
    return error{file +
                     ": the name does not say which kind of mesh it is; .obj, .stl, .ply, .mesh, "
                     ".msh and .vtu can be read",
                 error_code::unreadable_file};
  const auto text = read_text_file(path);
  if (!text) return text.failure();
  const std::string& t = text.value();
  if (has_ending(file, ".obj")) return parse_obj(t, file);
  if (has_ending(file, ".stl")) return parse_stl(t, file);
  if (has_ending(file, ".ply")) return parse_ply(t, file);
  if (has_ending(file, ".msh")) return parse_space_gmsh(t, file);
  if (has_ending(file, ".vtu")) return parse_space_vtu(t, file);
  return parse_space_medit(t, file);
}

}  // namespace asterism::internal
