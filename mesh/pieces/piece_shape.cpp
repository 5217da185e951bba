// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/piece_shape.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "asterism/mesh/pieces/piece_curves.hpp"

namespace asterism::internal {
namespace {

// Returns the edge as a segment of the piece, with the piece on its left.
segment segment_of(const cut_edge& e, piece_index piece) {
  segment s{e.a, e.b, e.marker, false, e.left_region, 1};
  if (e.left == piece && e.right == piece) {
    s.internal = true;
    s.right_region = e.right_region;
  } else if (e.left != piece) {
    std::swap(s.a, s.b);
    s.left_region = e.right_region;
  }
  return s;
}

}  // namespace

piece_shape shape_of_piece(const domain& d, const domain_cut& cut, const seam_points& points,
                           piece_index piece) {
  piece_shape made;
  std::vector<char> is_used(cut.vertices.size(), 0);
  for (std::size_t e = 0; e < cut.edges.size(); ++e) {
    const cut_edge& edge = cut.edges[e];
    if (edge.left != piece && edge.right != piece) continue;
    made.shape.segments.push_back(segment_of(edge, piece));
    made.edge_of.push_back(e);
    is_used[edge.a] = is_used[edge.b] = 1;
    std::optional<std::vector<point>> division;
    if (edge.is_seam()) {
      division = points[e];
      if (edge.left != piece) std::reverse(division->begin(), division->end());
    }
    made.divisions.push_back(std::move(division));
  }
  for (vertex_index v = 0; v < cut.given; ++v)
    if (cut.piece_of_loose[v] == piece) is_used[v] = 1;
  std::vector<vertex_index> number(cut.vertices.size(), 0);
  for (vertex_index v = 0; v < cut.vertices.size(); ++v) {
    if (is_used[v] == 0) continue;
    number[v] = static_cast<vertex_index>(made.shape.vertices.size());
    made.shape.vertices.push_back(cut.vertices[v]);
  }
  for (segment& s : made.shape.segments) {
    s.a = number[s.a];
    s.b = number[s.b];
  }
  made.shape.curves = curves_of_piece(d, cut, piece);
  for (domain_curve& c : made.shape.curves)
    for (std::uint32_t& v : c.vertices) v = number[v];
  return made;
}

}  // namespace asterism::internal
