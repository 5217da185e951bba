// SPDX-License-Identifier: MIT
//
// Holds the question of a surface's mesh, and the report of its proof.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asterism::internal {

struct shell_question {
  double chord = 0;           // D
  double angle_bound = 20;    // degrees, of the plane meshes
  bool no_crossings = false;  // point 7
  std::size_t findings_kept = 10;
};

struct shell_report {
  bool certified = false;
  std::vector<std::string> findings;  // a sentence each; faces and triangles count from 1
  std::size_t found = 0;

  std::size_t vertices = 0, triangles = 0, edges = 0, open_edges = 0, collapsed = 0;
  long euler = 0;              // vertices - edges + triangles
  double distance = 0;         // an upper bound of both one-sided distances
  double vertex_distance = 0;  // of a vertex from the point of the surface that it stands for
  double normal_tangent = 0;   // upper bound of the tangent of the greatest normal deviation
  double least_angle = 180;    // degrees, of the plane meshes, in their metrics
  double least_angle_in_space = 180;  // degrees; for information
  std::size_t folded = 0;             // triangles for which point 3 could not be proved

  // Measures of trimmed patches, each meshed within the polygon through the places on its curves.
  std::size_t trims = 0;       // curves
  double trim_distance = 0;    // an upper bound of the distance in space of polygons and curves
  std::size_t trim_edges = 0;  // that two curves have
  double trim_gap = 0;         // an upper bound of the distance of the two curves of one edge
};

}  // namespace asterism::internal
