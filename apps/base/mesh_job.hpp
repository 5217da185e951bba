// SPDX-License-Identifier: MIT
//
// Holds the options of the main job: domain, metric, mesh, files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"
#include "asterism/mesh/pipeline/mesh_input.hpp"

namespace asterism::apps {

struct mesh_job {
  std::string domain;
  std::string metric = "identity";
  std::optional<double> size;
  std::optional<double> complexity;       // in place of a size: the area as the metric measures it
  size_wishes sizes;                      // at places, and bounds on all
  bool sizes_of_file = false;             // areas of the domain's regions are sizes
  std::optional<double> gradation;        // beta; empty: the metric is taken as it is
  bool repair = false;                    // what the domain's file has wrong
  std::optional<double> repair_distance;  // empty: as little as suffices
  std::optional<double> chord_tolerance;  // empty: a part of each chord
  bool number_regions = false;            // those the domain does not number, too
  bool convex_hull = false;               // of the vertices, as segments
  bool guarantee = false;               // edges are made shorter until the theorem on nets applies
  std::vector<periodic_pair> periodic;  // sides that are to have the same points
  bool no_split_across = false;         // no inner edge joins two vertices of the boundary
  std::size_t random_points = 0;
  std::size_t pieces = 0;                  // 0: the mesh is made in one
  std::vector<std::string> piece_formats;  // endings of further files of each piece
  bool resume = false;                     // pieces that are there already are kept
  mesh_options refinement;                 // its seed is the random points' too
  bool keeps_site_limit = false;           // else it is raised where the domain has many vertices
  std::vector<std::filesystem::path> outputs;
  std::filesystem::path certificate;    // empty: beside the first output
  std::filesystem::path proof;          // empty: none is written
  std::size_t threads = 0;              // 0: one for each processor
  std::optional<double> max_seconds;    // of wall time, for refinement
  std::optional<double> max_megabytes;  // of resident memory
  int order = 1;                        // of the triangles in files that hold second ones
  bool ellipses = false;
  bool quiet = false;
  bool strict = false;  // what readers change is refused
  bool json = false;    // the summary for programs

  // Metric field in place of the one that `metric` names, divided by the square of a size; set only
  // by programs that bring a field along.
  field_in_box field;

  // True if lines of text go to standard output.
  bool tells() const { return !quiet && !json; }
};

}  // namespace asterism::apps
