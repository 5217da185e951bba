// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/voronoi_edge.hpp"

#include <algorithm>
#include <limits>

#include "asterism/mesh/support/sort_unique.hpp"

namespace asterism::internal::audit_detail {
namespace {

offset end_at(const audit_context& context, const voronoi_vertices& vertices, vertex_index v,
              vertex_index t) {
  const offset to_first = between(context.at(v), context.at(context.subject.triangles[t][0]));
  const offset& vertex = vertices[t].from_first;
  return {to_first.x + vertex.x, to_first.y + vertex.y};
}

}  // namespace

dual_edge dual_of(const audit_context& context, const voronoi_vertices& vertices,
                  const directed_edge& edge) {
  dual_edge dual{edge.a, edge.b, edge.triangle, edge.apex};
  const std::size_t across = find_edge(context, edge.b, edge.a);
  dual.on_boundary = across == context.edges.size();
  dual.has_ends = vertices[dual.left].found;
  dual.to = end_at(context, vertices, dual.v, dual.left);
  if (dual.on_boundary) {
    const site &v = context.subject.sites[dual.v], &u = context.subject.sites[dual.u];
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bounded unknown = bounded::within(0, infinity);
    dual.from = enclose_bisector_point(v, u, between(v.position, u.position))
                    .value_or(offset{unknown, unknown});
    return dual;
  }
  dual.right = context.edges[across].triangle;
  dual.right_apex = context.edges[across].apex;
  dual.has_ends = dual.has_ends && vertices[dual.right].found;
  dual.from = end_at(context, vertices, dual.v, dual.right);
  return dual;
}

sign dual_edge_question::order_of_ends() {
  ++tally_.part.decisions;
  const bounded turn = cross(edge_.from, edge_.to);
  if (turn.certainly_positive()) return sign::positive;
  if (turn.certainly_negative()) return sign::negative;
  if (!edge_.on_boundary && has_equal_metrics(edge_.right_apex))
    return excess_at_left(edge_.right_apex);
  ++tally_.part.exact_decisions;
  find_parameters();
  return from_ && to_ ? exact_voronoi_arc::order(*to_, *from_) : sign::negative;
}

// True if all sites concerned have one metric. Then the bisectors are lines, and f_w - f_v is
// linear along the dual arc.
bool dual_edge_question::has_equal_metrics(vertex_index w) const {
  const metric_tensor& metric = at(edge_.v).metric;
  return identical(metric, at(edge_.u).metric) && identical(metric, at(w).metric) &&
         identical(metric, at(edge_.left_apex).metric) &&
         (edge_.on_boundary || identical(metric, at(edge_.right_apex).metric));
}

sign dual_edge_question::excess_at_left(vertex_index w) const {
  const site& v = at(edge_.v);
  return excess_at_centre(v.metric, v.position, context_.at(edge_.u), context_.at(edge_.left_apex),
                          context_.at(w));
}

sign dual_edge_question::excess_at_right(vertex_index w) const {
  const site& v = at(edge_.v);
  return excess_at_centre(v.metric, context_.at(edge_.u), v.position, context_.at(edge_.right_apex),
                          context_.at(w));
}

arc_meeting dual_edge_question::meeting_with(vertex_index w) {
  if (has_equal_metrics(w)) {
    const sign left = w == edge_.left_apex ? sign::zero : excess_at_left(w);
    // Accepts no tie at an end on the boundary: a site that is equally near there is found by the
    // test of the boundary edge.
    const sign right = edge_.on_boundary       ? sign::positive
                       : w == edge_.right_apex ? sign::zero
                                               : excess_at_right(w);
    return {left == sign::negative || right == sign::negative,
            left == sign::zero && right == sign::zero, right == sign::zero, left == sign::zero};
  }
  ++tally_.part.voronoi_pairs_exact;
  find_parameters();
  // Requires both ends of the dual edge: callers ask only where these exist.
  if (!from_ || !to_) return {true, true, true, true};
  return exact_->meeting_with(at(w), *from_, *to_);
}

// Skips the test for sites with one metric: a point equally far from all of them is in the wedges
// of every two.
bool dual_edge_question::is_wedged_with(vertex_index w, vertex_index t) {
  if (has_equal_metrics(w)) return true;
  ++tally_.part.exact_decisions;
  find_parameters();
  const auto& end = t == edge_.left ? to_ : from_;
  return end && exact_->is_wedged_with(at(w), *end);
}

void dual_edge_question::find_parameters() {
  if (exact_) return;
  exact_.emplace(at(edge_.v), at(edge_.u));
  from_ =
      edge_.on_boundary ? exact_voronoi_arc::on_segment() : exact_->vertex(at(edge_.right_apex));
  to_ = exact_->vertex(at(edge_.left_apex));
}

std::vector<vertex_index> voronoi_polygon(const audit_context& context, audit_tally& tally,
                                          const voronoi_vertices& vertices, vertex_index t) {
  std::vector<vertex_index> triangles{t}, corners;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const triangle& own = context.subject.triangles[triangles[k]];
    corners.insert(corners.end(), own.begin(), own.end());
    for (std::size_t i = 0; i < 3; ++i) {
      const directed_edge& edge = context.edges[find_edge(context, own[i], own[(i + 1) % 3])];
      const dual_edge dual = dual_of(context, vertices, edge);
      if (dual.on_boundary || !dual.has_ends) continue;
      if (std::find(triangles.begin(), triangles.end(), dual.right) != triangles.end()) continue;
      if (dual_edge_question(context, tally, dual).order_of_ends() == sign::zero)
        triangles.push_back(dual.right);
    }
  }
  sort_unique(corners);
  return corners;
}

}  // namespace asterism::internal::audit_detail
