// SPDX-License-Identifier: MIT
//
// Holds the dual of one edge of a mesh: the part of the Voronoi arc of its two sites between the
// Voronoi vertices of the triangles beside it. Answers the questions about it that doubles with
// error bounds leave undecided, ties included, and lists the polygon of sites around a Voronoi
// vertex. Source: docs/math/voronoi-certificate.md.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/audit/voronoi_exact.hpp"

namespace asterism::internal::audit_detail {

// The Voronoi vertex of a triangle; empty when it has none that is wedged.
struct voronoi_vertex {
  bool found = false;
  offset from_first;  // from the triangle's first corner
};

using voronoi_vertices = std::vector<voronoi_vertex>;

// The edge from v to u. Its dual arc goes counter-clockwise around v, from the vertex of the
// triangle on the right, or from the edge itself on the boundary, to the vertex of the triangle on
// the left.
struct dual_edge {
  vertex_index v = 0, u = 0;
  vertex_index left = 0, left_apex = 0;  // triangle, and its third corner
  bool on_boundary = false;              // then nothing on the right
  vertex_index right = 0, right_apex = 0;
  bool has_ends = false;  // both Voronoi vertices are there
  offset from{}, to{};    // the ends, from v
};

dual_edge dual_of(const audit_context& context, const voronoi_vertices& vertices,
                  const directed_edge& edge);

// Exact answers about one dual edge whose ends both exist.
class dual_edge_question {
 public:
  dual_edge_question(const audit_context& context, audit_tally& tally, const dual_edge& edge)
      : context_(context), tally_(tally), edge_(edge) {}

  // Returns the order of the two ends. Positive: the left end is counter-clockwise of the right one
  // around v, as it should be. Zero: the dual arc is a point.
  sign order_of_ends();
  // Returns at which points of the dual edge w is as near as the owners. Says nothing of an end on
  // the boundary.
  arc_meeting meeting_with(vertex_index w);
  // True if the end at triangle `at`, one of the edge's two, lies in the wedges of w and each
  // owner. Requires that w is as near to that end as the owners.
  bool is_wedged_with(vertex_index w, vertex_index at);

 private:
  const site& at(vertex_index v) const { return context_.subject.sites[v]; }
  bool has_equal_metrics(vertex_index w) const;
  sign excess_at_left(vertex_index w) const;
  sign excess_at_right(vertex_index w) const;
  void find_parameters();

  const audit_context& context_;
  audit_tally& tally_;
  dual_edge edge_;
  // Exact arc and the parameters of its ends, made when first needed.
  std::optional<exact_voronoi_arc> exact_;
  std::optional<exact_voronoi_arc::parameter> from_, to_;
};

// Returns the corners of all triangles that share the Voronoi vertex of t through edges whose dual
// arcs are points, ascending.
std::vector<vertex_index> voronoi_polygon(const audit_context& context, audit_tally& tally,
                                          const voronoi_vertices& vertices, vertex_index t);

}  // namespace asterism::internal::audit_detail
