// SPDX-License-Identifier: MIT
//
// Makes a plane graph of segments that cross, nearly meet, or have ends that nearly coincide. Works
// inside repair_domain.
//
// With a distance D, repeats three steps until nothing changes:
//  1. A point nearer than D to an earlier one becomes that one.
//  2. A segment that passes a point within D/2 is bent to go through it.
//  3. Segments that cross get their crossing for a vertex, its coordinates rounded once; or, where
//     a vertex is nearer than D to it, the nearest vertex.
// Every test is made exactly on the present doubles, and repeated after they were changed. Points
// of the input keep their coordinates.
//
// It ends: step 1 is done once, and afterwards vertices are D apart, so that there
// is room for a finite number; steps 2 and 3 replace a piece of a segment by pieces
// that are each strictly shorter. Step 2: at height h <= D/2 beside a piece, D from
// both its ends, a point makes the squared lengths less by 3 D^2 - 4 h^2 at least.
// Step 3: with x the crossing and v the vertex nearest to it, |av| < |ax| + |xv| <=
// |ax| + |xb| = |ab|. There are finitely many distances between finitely many
// points. At the end vertices are D apart or more, no piece passes one within D/2,
// and pieces meet in vertices alone. Source: the steps are those of iterated snap
// rounding (Halperin and Packer, 2002), with the points themselves in place of a
// grid's.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// A part of the segment `source` of the input, in its direction.
struct snapped_piece {
  vertex_index a = 0, b = 0;
  std::size_t source = 0;
};

// A vertex shared, after snapping, by two segments that crossed, or by a segment and a vertex that
// lay beside it.
struct snapped_meeting {
  vertex_index vertex = 0;
  std::size_t source = 0, other = 0;  // `other` a segment where they crossed, else a vertex
  bool crossed = false;
};

struct snapped_graph {
  std::vector<point> vertices;          // the input's, then those made
  std::vector<vertex_index> joined_to;  // of the input's vertices: the one that each became
  std::vector<snapped_piece> pieces;    // by source, and along it
  std::vector<snapped_meeting> meetings;
  std::size_t rounds = 0;
};

// Builds the graph. Requires finite coordinates, indices in range, and a distance of four units in
// the last place of every coordinate at least. Fails where there would be more than four million
// pieces, or when `stop` is requested; its account is charged with the work.
result<snapped_graph> snap_segments(const domain& d, double distance,
                                    const cancellation& stop = {});

}  // namespace asterism::internal
