// SPDX-License-Identifier: MIT
//
// Holds the options of reading a Medit mesh.
#pragma once

#include <filesystem>

namespace asterism {

// Options of reading: where the metric comes from, and which edges are segments.
struct medit_read_options {
  // True to give every vertex the identity if there is no .sol; otherwise that is an error.
  bool identity_without_solution = false;
  // True to give every vertex the identity without looking for a .sol.
  bool without_solution = false;
  // True if every listed edge is a segment, marked or not (mesh/io/medit_edges.hpp).
  bool all_edges = false;
  // File of the metric; by default the .sol beside the mesh.
  std::filesystem::path solution = {};
};

}  // namespace asterism
