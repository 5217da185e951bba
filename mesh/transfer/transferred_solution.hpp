// SPDX-License-Identifier: MIT
//
// Holds a solution that was transferred to another mesh, with a report.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/mesh/data/solution.hpp"

namespace asterism {

// Measures of one component of the solution, before and after.
struct transferred_component {
  std::string name;
  double integral_before = 0, integral_after = 0;
  double least_before = 0, greatest_before = 0, least_after = 0, greatest_after = 0;
};

// Report of the transfer.
struct transfer_report {
  std::vector<transferred_component> components;
  double area_before = 0, area_after = 0;
  double area_common = 0;          // 0 for interpolate, which does not ask
  std::size_t outside = 0;         // new vertices outside the old mesh, by exact orientations
  double greatest_distance = 0;    // of those from it
  std::size_t partly_covered = 0;  // new triangles with more than 1e-6 of them outside the old mesh
  std::size_t pieces = 0;          // common parts
};

// The solution at the new vertices.
struct transferred_solution {
  solution values;
  transfer_report report;
};

}  // namespace asterism
