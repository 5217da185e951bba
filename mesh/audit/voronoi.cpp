// SPDX-License-Identifier: MIT
//
// Is the mesh the dual of the anisotropic Voronoi diagram of its sites, restricted to the domain?
// Checked: (i) each triangle has a Voronoi vertex in the wedges of its three pairs; (ii) around
// each edge those of its two triangles are in order, and that of a triangle on the boundary is not
// beyond it; (iii) no site is nearer to a point of a Voronoi arc between them than the two ends of
// its edge; (iv) no site encroaches on a boundary edge.
// Requires what points 0 to 2 prove. Internal edges are edges like others here.
// Source: docs/math/voronoi-certificate.md, which proves that this is enough; the thesis,
// theorem 4.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/audit/context.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/audit/voronoi_exact.hpp"

namespace asterism::internal::audit_detail {
namespace {

// The Voronoi vertex of a triangle; empty when it has none that is wedged.
struct voronoi_vertex {
  bool found = false;
  offset from_first;  // from the triangle's first corner
};

using voronoi_vertices = std::vector<voronoi_vertex>;

class vertex_check {
 public:
  vertex_check(const audit_context& context, audit_tally& tally, voronoi_vertices& vertices)
      : context_(context), tally_(tally), vertices_(vertices) {}

  void run(vertex_index t) {
    const triangle& corners = context_.subject.triangles[t];
    const site &a = at(corners[0]), &b = at(corners[1]), &c = at(corners[2]);
    ++tally_.part.decisions;
    if (const auto found = enclose_voronoi_vertex(a, b, c)) {
      vertices_[t] = {true, *found};
      return;
    }
    ++tally_.part.exact_decisions;
    const exact_voronoi_arc arc(a, b);
    if (const auto found = arc.vertex(c)) {
      vertices_[t] = {true, arc.enclose(*found)};
      return;
    }
    tally_.found(finding_kind::voronoi_vertex_missing,
                 triangle_text(context_, t) + " has no Voronoi vertex that its corners all see");
  }

 private:
  const site& at(vertex_index v) const { return context_.subject.sites[v]; }

  const audit_context& context_;
  audit_tally& tally_;
  voronoi_vertices& vertices_;
};

// The edge from v to u. Its Voronoi arc goes counter-clockwise around v, from the vertex of the
// triangle on the right, or from the edge itself on the boundary, to that of the one on the left.
struct dual_edge {
  vertex_index v = 0, u = 0;
  vertex_index left = 0, left_apex = 0;  // triangle, and its third corner
  bool on_boundary = false;              // then nothing on the right
  vertex_index right = 0, right_apex = 0;
  bool has_ends = false;  // both Voronoi vertices are there
  offset from{}, to{};    // the ends, from v
};

class arc_check {
 public:
  arc_check(const audit_context& context, audit_tally& tally, const dual_edge& edge)
      : context_(context), tally_(tally), edge_(edge) {
    if (!edge.has_ends) return;
    const sign order = order_of_ends();
    if (order == sign::negative) report_order();
    // An arc that is a point is an end of others.
    if (order == sign::positive) enclosed_.emplace(at(edge.v), at(edge.u), edge.from, edge.to);
  }

  // Sites that matter are nearer than v to a point that v sees at this distance, at most.
  double reach() const {
    double reach = enclosed_ ? enclosed_->reach() : 0;
    if (edge_.on_boundary) {
      const offset d = between(at(edge_.v).position, at(edge_.u).position);
      reach =
          greatest_bound(reach, root(dot(d, tensor_of_doubles(at(edge_.v).metric) * d)).upper());
    }
    return reach;
  }

  void run(vertex_index w) {
    if (w == edge_.v || w == edge_.u) return;
    if (enclosed_) {
      ++tally_.part.voronoi_pairs;
      if (is_nearer(w)) report_nearer(w);
    }
    if (edge_.on_boundary && tally_.kernel.encroaches(at(edge_.v), at(edge_.u), at(w)))
      tally_.found(finding_kind::voronoi_boundary_encroached,
                   vertex_text(context_, w) + " encroaches on " + boundary_text());
  }

 private:
  const site& at(vertex_index v) const { return context_.subject.sites[v]; }

  // Positive: the left end is counter-clockwise of the other around v, as it should be.
  sign order_of_ends() {
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

  // Then the bisectors are lines, and a site is nearer to a point of the arc if it is to an end.
  bool has_equal_metrics(vertex_index w) const {
    const metric_tensor& metric = at(edge_.v).metric;
    return identical(metric, at(edge_.u).metric) && identical(metric, at(w).metric) &&
           identical(metric, at(edge_.left_apex).metric) &&
           (edge_.on_boundary || identical(metric, at(edge_.right_apex).metric));
  }
  sign excess_at_left(vertex_index w) const {
    const site& v = at(edge_.v);
    return excess_at_centre(v.metric, v.position, context_.at(edge_.u),
                            context_.at(edge_.left_apex), context_.at(w));
  }
  sign excess_at_right(vertex_index w) const {
    const site& v = at(edge_.v);
    return excess_at_centre(v.metric, context_.at(edge_.u), v.position,
                            context_.at(edge_.right_apex), context_.at(w));
  }

  bool is_nearer(vertex_index w) {
    const bool is_left = w == edge_.left_apex,
               is_right = !edge_.on_boundary && w == edge_.right_apex;
    const uncertain_bool at_once = enclosed_->is_nearer(at(w), is_right, is_left);
    if (at_once.certain()) return at_once.value();
    // Who is nearer at the end on the boundary encroaches on it.
    if (has_equal_metrics(w))
      return (!is_left && excess_at_left(w) == sign::negative) ||
             (!is_right && !edge_.on_boundary && excess_at_right(w) == sign::negative);
    ++tally_.part.voronoi_pairs_exact;
    find_parameters();
    // The ends are there: this is not reached without them.
    return !from_ || !to_ || exact_->is_nearer(at(w), *from_, *to_);
  }

  void find_parameters() {
    if (exact_) return;
    exact_.emplace(at(edge_.v), at(edge_.u));
    from_ =
        edge_.on_boundary ? exact_voronoi_arc::on_segment() : exact_->vertex(at(edge_.right_apex));
    to_ = exact_->vertex(at(edge_.left_apex));
  }

  std::string arc_text() const {
    return "the Voronoi arc between " + vertex_text(context_, edge_.v) + " and " +
           vertex_text(context_, edge_.u);
  }
  std::string boundary_text() const {
    return subsegment_text(context_,
                           static_cast<vertex_index>(find_subsegment(context_, edge_.v, edge_.u)));
  }

  void report_order() {
    const std::string left = triangle_text(context_, edge_.left);
    tally_.found(finding_kind::voronoi_arc_reversed,
                 edge_.on_boundary
                     ? "the Voronoi vertex of " + left + " is beyond " + boundary_text()
                     : arc_text() + " would run backwards, from the Voronoi vertex of " +
                           triangle_text(context_, edge_.right) + " to that of " + left);
  }

  void report_nearer(vertex_index w) {
    tally_.found(finding_kind::voronoi_site_nearer,
                 vertex_text(context_, w) + " is nearer to a point of " + arc_text() + ", beside " +
                     triangle_text(context_, edge_.left) + ", than they are");
  }

  const audit_context& context_;
  audit_tally& tally_;
  dual_edge edge_;
  std::optional<enclosed_arc> enclosed_;
  // Made when first needed.
  std::optional<exact_voronoi_arc> exact_;
  std::optional<exact_voronoi_arc::parameter> from_, to_;
};

// All arcs of v but those that a neighbour with a lesser number answers for, and the boundary edges
// that leave it.
class cell_check {
 public:
  cell_check(const audit_context& context, audit_tally& tally, const voronoi_vertices& vertices,
             const site_tree& sites)
      : context_(context), tally_(tally), vertices_(vertices), sites_(sites) {}

  void run(vertex_index v) {
    arcs_.clear();
    double reach = 0;
    for (std::size_t i = context_.edge_start[v]; i < context_.edge_start[v + 1]; ++i)
      if (const auto edge = dual_of(context_.edges[i])) {
        arcs_.emplace_back(context_, tally_, *edge);
        reach = greatest_bound(reach, arcs_.back().reach());
      }
    if (arcs_.empty()) return;
    sites_.visit_near(context_.subject.sites[v], reach, [&](vertex_index w) {
      for (arc_check& arc : arcs_) arc.run(w);
    });
  }

 private:
  std::optional<dual_edge> dual_of(const directed_edge& edge) const {
    dual_edge dual{edge.a, edge.b, edge.triangle, apex(context_, edge)};
    const std::size_t across = find_edge(context_, edge.b, edge.a);
    dual.on_boundary = across == context_.edges.size();
    if (!dual.on_boundary && edge.b < edge.a) return std::nullopt;
    dual.has_ends = vertices_[dual.left].found;
    dual.to = end_at(dual.v, dual.left);
    const site &v = context_.subject.sites[dual.v], &u = context_.subject.sites[dual.u];
    if (dual.on_boundary) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const bounded unknown = bounded::within(0, infinity);
      dual.from = enclose_bisector_point(v, u, between(v.position, u.position))
                      .value_or(offset{unknown, unknown});
      return dual;
    }
    dual.right = context_.edges[across].triangle;
    dual.right_apex = apex(context_, context_.edges[across]);
    dual.has_ends = dual.has_ends && vertices_[dual.right].found;
    dual.from = end_at(dual.v, dual.right);
    return dual;
  }

  offset end_at(vertex_index v, vertex_index t) const {
    const offset to_first = between(context_.at(v), context_.at(context_.subject.triangles[t][0]));
    const offset& vertex = vertices_[t].from_first;
    return {to_first.x + vertex.x, to_first.y + vertex.y};
  }

  const audit_context& context_;
  audit_tally& tally_;
  const voronoi_vertices& vertices_;
  const site_tree& sites_;
  std::vector<arc_check> arcs_;  // of the cell at hand; a member to spare allocations
};

}  // namespace

void check_voronoi(audit_context& context) {
  voronoi_vertices vertices(context.subject.triangles.size());
  check_in_parallel(context, vertices.size(),
                    [&](audit_tally& tally, std::size_t begin, std::size_t end) {
                      vertex_check part(context, tally, vertices);
                      for (std::size_t t = begin; t < end; ++t)
                        part.run(static_cast<vertex_index>(t));
                    });
  const site_tree sites(context.subject.sites);
  const std::vector<vertex_index>& order = sites.order();
  check_in_parallel(context, order.size(),
                    [&](audit_tally& tally, std::size_t begin, std::size_t end) {
                      cell_check part(context, tally, vertices, sites);
                      for (std::size_t i = begin; i < end; ++i) part.run(order[i]);
                    });
  bool refused = false;
  for (const finding_kind kind :
       {finding_kind::voronoi_vertex_missing, finding_kind::voronoi_arc_reversed,
        finding_kind::voronoi_site_nearer, finding_kind::voronoi_boundary_encroached})
    refused = refused || context.report.found[static_cast<std::size_t>(kind)] != 0;
  context.report.voronoi = refused ? voronoi_verdict::refused : voronoi_verdict::proved;
}

}  // namespace asterism::internal::audit_detail
