// SPDX-License-Identifier: MIT
//
// Turns the cells of VTK's grids into triangles, quadrilaterals and edges.
//
// Triangles (5), strips of them (6), pixels (8), quadrilaterals (9), polygons (7) of three or four
// points and lines (3, 4) are read; those of higher order (21 to 23, 28, 34, 35, 68 to 70) by their
// corners; points (1, 2) are skipped; other cells are refused. Regions and markers are the values
// of one array of cell data: the first one with a name that programs use for them (such as region,
// gmsh:physical, medit:ref), else the only one of whole numbers, with a note. Source:
// vtkCellType.h, as "VTK File Formats" has it.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/io/listed_mesh.hpp"

namespace asterism::internal {

struct vtk_cell {
  int type;
  std::size_t number;  // from 0
  std::size_t line;
  const double* points;  // whole numbers
  std::size_t count;
};

class vtk_cells {
 public:
  explicit vtk_cells(listed_mesh& made) : made_(made) {}

  std::optional<error> add(const vtk_cell& cell);
  // Regions and markers: one whole number for each cell.
  void set_numbers(const std::vector<double>& of_cells);
  // Returns the index of each triangle's cell.
  const std::vector<std::size_t>& triangles() const { return triangles_; }

 private:
  std::optional<error> add_corners(const vtk_cell& cell, std::size_t corners);
  void add_triangle(const vtk_cell& cell, const triangle& t);

  listed_mesh& made_;
  std::vector<std::size_t> triangles_, quadrilaterals_, lines_;  // their cells
  std::vector<vertex_index> found_;
};

// An array of cell data that may number the regions.
struct vtk_candidate {
  std::string_view name;
  bool whole_numbers;
  std::size_t line;
};

// Chooses the array of cell data that numbers the regions; none where there is none. An array that
// fits only by its values is taken, with a note, if it is the only one; if there are several the
// file is refused. Notes the names of arrays of other numbers.
result<std::optional<std::size_t>> choose_region_array(const std::vector<vtk_candidate>& arrays,
                                                       listed_mesh& m);

}  // namespace asterism::internal
