// SPDX-License-Identifier: MIT
//
// Holds the result of meshing as plain data, for files, pictures and the auditor.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism {

// A boundary edge, part of a segment; the domain lies to the left of a -> b, and on the right too
// when the segment is internal.
struct boundary_edge {
  vertex_index a = 0, b = 0;
  vertex_index segment = 0;  // index into domain::segments of the segment it is a subsegment of
  int marker = 0;
  bool internal = false;
};

using triangle = std::array<vertex_index, 3>;  // counter-clockwise
using triangle_sites = std::array<site, 3>;    // the sites of one

// A mesh. Every index refers to `sites`. `sites[0 .. given)` are the domain's vertices in their
// order, bit for bit. `triangles` holds only triangles on which all three stars agree.
struct mesh {
  std::vector<site> sites;
  vertex_index given = 0;
  std::vector<triangle> triangles;
  // The region of each triangle; empty if all are in region 1. In a mesh with gaps 0 is the number
  // of a triangle that is joined to no segment.
  std::vector<int> regions;
  // Subsegments, each listed once, internal ones in the direction of their segment.
  std::vector<boundary_edge> boundary;
  std::vector<triangle> disagreeing;  // empty when refinement was complete
  // References of vertices, where a file gives others than the markers of its edges; else empty.
  // They are kept and part of the fingerprint, and have no other use.
  std::vector<int> references;
  // Notes on what its reader changed or left out, a sentence each; empty for a mesh made here. Not
  // part of the fingerprint.
  std::vector<std::string> notes = {};
};

}  // namespace asterism
