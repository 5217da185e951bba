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

// A subsegment of a split segment; the domain lies to the left of a -> b, and on the right too when
// the segment is internal.
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
  // The region of each triangle; empty if all are in region 1. 0 is also the number of a triangle
  // which no others join to a segment, in a mesh with gaps.
  std::vector<int> regions;
  // Each subsegment once, internal ones in the direction of their segment.
  std::vector<boundary_edge> boundary;
  std::vector<triangle> disagreeing;  // empty when refinement was complete
  // References of vertices, where a file gives others than the markers of its edges; else empty.
  // Carried along and part of the fingerprint, and without any other use.
  std::vector<int> references;
  // Changes and omissions of its reader, a sentence each; empty for a mesh made here. No part of
  // the fingerprint.
  std::vector<std::string> notes = {};
};

}  // namespace asterism
