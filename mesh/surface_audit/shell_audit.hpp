// SPDX-License-Identifier: MIT
//
// Proves what a mesh of a surface claims, from the surface, the plane meshes and the shell alone.
//
// A certified shell is proven to
//  1. have a certified plane mesh of each patch's whole square of parameters (audit/audit.hpp);
//  2. be within D: every point of the surface within D of the mesh and of the mesh within D of the
//     surface;
//  3. be nowhere folded: (r_u x r_v).n_T > 0 on each triangle's whole piece, but at a side of a
//     patch that is one point, where r_u x r_v is zero and its direction is meant;
//  4. have the greatest normal deviation that is given, or less;
//  5. have its vertices on the surface up to the rounding that is given;
//  6. have every edge once each way, but those of open sides, which are counted; vertices that are
//     shared are one vertex.
// docs/math/surfaces.md has the proofs. Angles in space are reported, not certified.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"

namespace asterism::internal {

struct shell_question {
  double chord = 0;         // D
  double angle_bound = 20;  // degrees, of the plane meshes
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
};

// Fails where the surface is refused, or an index or a number of the shell is out of range.
result<shell_report> audit_shell(const surface& s, const surface_shell& shell,
                                 const shell_question& asked);

// For who makes a shell: an upper bound of the distances between a plane triangle and its piece of
// the surface, either no more than 5 % above a point's distance or below `enough`; and whether the
// surface is not folded over it, as far as doubles tell in a few places.
struct shell_measure {
  double distance = 0;
  bool is_unfolded = false;
};
result<std::vector<shell_measure>> shell_measures(const surface& s, const surface_shell& shell,
                                                  double enough);

}  // namespace asterism::internal
