// SPDX-License-Identifier: MIT
//
// Cuts a domain into pieces along segments.
//
// A star does not see across a segment. So where a domain is cut along segments, each piece can be
// meshed and certified by itself, and the meshes together are one of the whole domain if they meet
// bit for bit (docs/math/pieces.md). The cuts are edges of a coarse mesh of the domain in the same
// metric. So the corners at their ends are as wide in the metric as angles of that mesh, and cuts
// go around narrow places. Pieces have about the same metric area.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/pieces/cut_wishes.hpp"

namespace asterism::internal {

inline constexpr vertex_index no_segment = std::numeric_limits<vertex_index>::max();

// An edge of the cut domain: a part of a segment of the domain, or a cut. `left` is the piece on
// the left of a -> b, `right` the one on the right, if the domain is on that side.
struct cut_edge {
  vertex_index a = 0, b = 0;  // into domain_cut::vertices
  int marker = 0;
  vertex_index segment = no_segment;  // of the domain, that it is a part of; none: a cut
  int left_region = 1, right_region = 1;
  piece_index left = no_piece, right = no_piece;

  bool is_cut() const { return segment == no_segment; }
  // True if two pieces meet in the edge.
  bool is_seam() const { return left != right && left != no_piece && right != no_piece; }
};

// A domain cut into pieces.
struct domain_cut {
  std::size_t pieces = 0;
  vertex_index given = 0;  // the domain's vertices, which are the first, in their order
  std::vector<point> vertices;
  // The parts of the domain's segments, in the order of the segments and, within one segment, of
  // their places along it; then the cuts.
  std::vector<cut_edge> edges;
  // Piece of each given vertex that is on no edge; none for the others.
  std::vector<piece_index> piece_of_loose;
  int marker = 0;  // of cuts: greater than all of the domain's
};

// Cuts a domain, accepted by check_domain, into this number of pieces. Cuts curves along their
// chords. Fails where the field does, for less than about six triangles a piece, and if the coarse
// mesh is no triangulation of the domain or was stopped. The result is the same for any number of
// threads.
result<domain_cut> cut_domain(const domain& d, const metric_field& field, const cut_wishes& wishes);

// Returns the cut along the edges of a mesh of the domain, between triangles of different pieces.
domain_cut cut_along(const domain& d, const mesh& coarse, const std::vector<piece_index>& piece_of,
                     std::size_t pieces);

}  // namespace asterism::internal
