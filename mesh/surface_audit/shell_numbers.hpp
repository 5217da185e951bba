// SPDX-License-Identifier: MIT
// Lists the numbers of a shell's report that certificates state, in one place for all functions
// that write, read, compare or print them.
#pragma once

#include "asterism/mesh/surface_audit/shell_report.hpp"

namespace asterism::internal {

// Calls visit(key, words, member) for each number: its name in files, its name in messages, and the
// member of shell_report that holds it.
template <class Visit>
void visit_numbers(const Visit& visit) {
  visit("vertices", "vertices", &shell_report::vertices);
  visit("triangles", "triangles", &shell_report::triangles);
  visit("edges", "edges", &shell_report::edges);
  visit("open_edges", "open edges", &shell_report::open_edges);
  visit("collapsed", "triangles that are none in space", &shell_report::collapsed);
  visit("euler", "Euler number", &shell_report::euler);
  visit("distance", "distance", &shell_report::distance);
  visit("vertex_distance", "distance of vertices", &shell_report::vertex_distance);
  visit("normal_tangent", "tangent of the normals' deviation", &shell_report::normal_tangent);
  visit("least_angle", "least angle", &shell_report::least_angle);
}

// Calls visit(key, words, member) for the numbers that are written for trimmed patches alone.
template <class Visit>
void visit_trim_numbers(const Visit& visit) {
  visit("trims", "trimming curves", &shell_report::trims);
  visit("trim_distance", "distance of their chords", &shell_report::trim_distance);
  visit("trim_edges", "edges of two trimmed faces", &shell_report::trim_edges);
  visit("trim_gap", "gap along edges", &shell_report::trim_gap);
}

}  // namespace asterism::internal
