// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/vtk_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "asterism/core/number_text.hpp"

namespace asterism::internal {
namespace {

using failure = std::optional<error>;

constexpr int point_cell = 1, points_cell = 2, polyline_cell = 4, strip_cell = 6, polygon_cell = 7,
              pixel_cell = 8;

// Cells by number: the number of corners, which are the first of its points, and the number of
// points; 0 points mean any number.
struct cell_kind {
  int type;
  std::size_t corners, points;
};
constexpr std::array<cell_kind, 13> kinds = {{{3, 2, 2},
                                              {5, 3, 3},
                                              {8, 4, 4},
                                              {9, 4, 4},
                                              {21, 2, 3},
                                              {22, 3, 6},
                                              {23, 4, 8},
                                              {28, 4, 9},
                                              {34, 3, 7},
                                              {35, 2, 4},
                                              {68, 2, 0},
                                              {69, 3, 0},
                                              {70, 4, 0}}};

// Names that programs give to the numbers of materials and markers: Asterism's, gmsh's, Medit's,
// FreeFEM's, Elmer's, meshio's.
constexpr std::array<std::string_view, 12> names_of_regions = {
    "region",      "regions",   "gmsh:physical", "medit:ref", "Label",      "CellEntityIds",
    "GeometryIds", "cell_tags", "reference",     "material",  "MaterialID", "materialid"};
// Names of arrays that are neither regions nor lost: counts and numbers of the cells themselves,
// and what this library writes of each triangle.
constexpr std::array<std::string_view, 8> other_names = {
    "disagreeing",   "smallest_angle",   "vtkGhostType",     "vtkOriginalCellIds",
    "GlobalCellIds", "GlobalElementIds", "gmsh:geometrical", "vtkGhostLevels"};

bool is_other(std::string_view name) {
  return std::find(other_names.begin(), other_names.end(), name) != other_names.end();
}

error refuse_cell(const listed_mesh& m, std::size_t line, const std::string& what) {
  return {fmt::format("{}:{}: {}", m.file, line, what), error_code::malformed_file};
}

}  // namespace

std::optional<error> vtk_cells::add(const vtk_cell& cell) {
  if ((cell.type == point_cell && cell.count == 1) || cell.type == points_cell) return {};
  found_.clear();
  const auto points = static_cast<double>(made_.content.sites.size());
  for (std::size_t i = 0; i < cell.count; ++i) {
    const double number = cell.points[i];
    if (!(number >= 0 && number < points))
      return refuse_cell(
          made_, cell.line,
          fmt::format("cell {}: point {:.0f}, from 0, does not exist; there are {:.0f}",
                      cell.number + 1, number, points));
    found_.push_back(static_cast<vertex_index>(number));
  }
  if (cell.type == polyline_cell) {
    for (std::size_t i = 0; i + 1 < cell.count; ++i) {
      lines_.push_back(cell.number);
      auto& edges = made_.content.boundary;
      edges.push_back({found_[i], found_[i + 1], static_cast<vertex_index>(edges.size()), 0});
    }
    return {};
  }
  if (cell.type == strip_cell) {
    for (std::size_t i = 0; i + 2 < cell.count; ++i)
      add_triangle(cell, i % 2 == 0 ? triangle{found_[i], found_[i + 1], found_[i + 2]}
                                    : triangle{found_[i + 1], found_[i], found_[i + 2]});
    return {};
  }
  if (cell.type == polygon_cell && (cell.count == 3 || cell.count == 4))
    return add_corners(cell, cell.count);
  for (const cell_kind& kind : kinds) {
    const bool fits = kind.points == 0 ? cell.count >= kind.corners : cell.count == kind.points;
    if (kind.type == cell.type && fits) return add_corners(cell, kind.corners);
  }
  return refuse_cell(made_, cell.line,
                     fmt::format("cell {} is of type {} with {} points: triangles, quadrilaterals, "
                                 "lines and points can be read",
                                 cell.number + 1, cell.type, cell.count));
}

std::optional<error> vtk_cells::add_corners(const vtk_cell& cell, std::size_t corners) {
  if (cell.count > corners) ++made_.second_order;
  constexpr std::array<int, 5> quadratic = {21, 22, 23, 28, 34};
  if (std::find(quadratic.begin(), quadratic.end(), cell.type) != quadratic.end())
    for (std::size_t k = 0; k < (corners == 2 ? 1 : corners); ++k)
      made_.sides.push_back({found_[k], found_[(k + 1) % corners], found_[corners + k]});
  mesh& m = made_.content;
  if (corners == 2) {
    lines_.push_back(cell.number);
    m.boundary.push_back({found_[0], found_[1], static_cast<vertex_index>(m.boundary.size()), 0});
  } else if (corners == 3) {
    add_triangle(cell, {found_[0], found_[1], found_[2]});
  } else {
    if (cell.type == pixel_cell) std::swap(found_[2], found_[3]);
    quadrilaterals_.push_back(cell.number);
    made_.quadrilaterals.push_back({{found_[0], found_[1], found_[2], found_[3]}, 1, cell.line});
  }
  return {};
}

void vtk_cells::add_triangle(const vtk_cell& cell, const triangle& t) {
  triangles_.push_back(cell.number);
  made_.content.triangles.push_back(t);
}

void vtk_cells::set_numbers(const std::vector<double>& of_cells) {
  mesh& m = made_.content;
  const auto number = [&](std::size_t cell) {
    return made_.wide.number(static_cast<long long>(of_cells[cell]));
  };
  m.regions.clear();
  for (const std::size_t cell : triangles_) m.regions.push_back(number(cell));
  for (std::size_t i = 0; i < quadrilaterals_.size(); ++i)
    made_.quadrilaterals[i].region = number(quadrilaterals_[i]);
  for (std::size_t i = 0; i < lines_.size(); ++i) m.boundary[i].marker = number(lines_[i]);
}

namespace {

// Notes the arrays that hold values on triangles, for which a mesh has no place.
void note_values(const std::vector<vtk_candidate>& arrays, std::optional<std::size_t> chosen,
                 listed_mesh& m) {
  std::string names;
  for (std::size_t i = 0; i < arrays.size(); ++i)
    if (i != chosen && !arrays[i].whole_numbers && !is_other(arrays[i].name))
      names += (names.empty() ? "" : ", ") + quoted_token(arrays[i].name);
  if (!names.empty())
    m.content.notes.push_back("values on triangles have no place here and are passed over: " +
                              names);
}

result<std::optional<std::size_t>> find_region_array(const std::vector<vtk_candidate>& arrays,
                                                     listed_mesh& m) {
  using chosen = std::optional<std::size_t>;
  for (const std::string_view name : names_of_regions)
    for (std::size_t i = 0; i < arrays.size(); ++i)
      if (arrays[i].name == name) return chosen(i);
  chosen only;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    if (!arrays[i].whole_numbers || is_other(arrays[i].name)) continue;
    if (only)
      return refuse_cell(
          m, arrays[i].line,
          fmt::format("cell data {} and {} hold whole numbers, and none is named region: "
                      "name the one that is so",
                      quoted_token(arrays[*only].name), quoted_token(arrays[i].name)));
    only = i;
  }
  if (only)
    m.content.notes.push_back("the cell data " + quoted_token(arrays[*only].name) +
                              " are taken for the regions");
  return only;
}

}  // namespace

result<std::optional<std::size_t>> choose_region_array(const std::vector<vtk_candidate>& arrays,
                                                       listed_mesh& m) {
  const auto found = find_region_array(arrays, m);
  if (found) note_values(arrays, found.value(), m);
  return found;
}

}  // namespace asterism::internal
