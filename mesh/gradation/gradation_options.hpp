// SPDX-License-Identifier: MIT
//
// Holds the options of gradation, and the report of its work.
#pragma once

#include <cstddef>

#include "asterism/mesh/support/cancellation.hpp"

namespace asterism {

// Options of gradation.
struct gradation_options {
  double beta = 1.1;               // above 1, finite
  std::size_t max_nodes = 200000;  // of the grid, exceeded by a few
  int max_sweeps = 200;            // over all its nodes
  cancellation stop = {};          // polled now and then
};

// The work and effect of gradation.
struct gradation_report {
  double beta = 0;
  std::size_t nodes = 0, changed = 0;          // of the grid
  double largest_growth = 1;                   // of sqrt(det M), at the nodes
  double smallest_cell = 0, largest_cell = 0;  // longer sides, in units of the domain
  int sweeps = 0;
  bool settled = true;   // the last sweep changed nothing
  bool resolved = true;  // the grid was refined wherever it should be
};

}  // namespace asterism
