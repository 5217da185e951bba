// SPDX-License-Identifier: MIT
//
// Decides whether the mesh is the dual of the anisotropic Voronoi diagram of its sites, restricted
// to the domain. Checked: (i) each triangle has a Voronoi vertex in the wedges of its three pairs;
// (ii) beside each edge the Voronoi vertices of its two triangles are in order, and that of a
// triangle at a boundary edge is not beyond the edge; (iii) every other site is farther from each
// point of a Voronoi arc between them than the two ends of its edge, except at its own Voronoi
// vertices; (iv) every other site is farther from each point of a boundary edge than the nearer
// end, with the same exception. Requires what points 0 to 2 prove. Internal edges are edges like
// others here. Source: docs/math/voronoi-certificate.md, which proves that this is enough; the
// thesis, theorem 4.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/audit/audit_work.hpp"
#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/site_tree.hpp"
#include "asterism/mesh/audit/voronoi_arc.hpp"
#include "asterism/mesh/audit/voronoi_edge.hpp"
#include "asterism/mesh/audit/voronoi_exact.hpp"

namespace asterism::internal::audit_detail {
namespace {

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
    constexpr double an_exact_vertex = 100;  // a millisecond
    tally_.looked_units += an_exact_vertex;
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

// Tests the dual edge of one mesh edge against the sites near it.
class arc_check {
 public:
  arc_check(const audit_context& context, audit_tally& tally, const voronoi_vertices& vertices,
            const dual_edge& edge)
      : context_(context),
        tally_(tally),
        vertices_(vertices),
        edge_(edge),
        question_(context, tally, edge) {
    if (!edge.has_ends) return;
    order_ = question_.order_of_ends();
    if (order_ == sign::negative) report_order();
    // Encloses no arc that is a single point: the point is an end of other arcs, and is tested with
    // these.
    if (order_ == sign::positive) enclosed_.emplace(at(edge.v), at(edge.u), edge.from, edge.to);
  }

  // Returns an upper bound of v's distance to the points of the dual edge and, on the boundary, of
  // the edge itself: only sites as near as v to one of these points matter.
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
      check_arc(w);
    }
    if (edge_.on_boundary) check_boundary(w);
  }

 private:
  const site& at(vertex_index v) const { return context_.subject.sites[v]; }

  void check_arc(vertex_index w) {
    const bool is_left = w == edge_.left_apex,
               is_right = !edge_.on_boundary && w == edge_.right_apex;
    const uncertain_bool at_once = enclosed_->is_nearer(at(w), is_right, is_left);
    if (at_once.certainly(true)) return report_nearer(w, "is nearer to");
    if (at_once.certainly(false)) return;
    const arc_meeting meeting = question_.meeting_with(w);
    if (meeting.nearer) return report_nearer(w, "is nearer to");
    if (meeting.between) return report_nearer(w, "is as near to");
    if (meeting.at_to && !is_left) check_tie(w, edge_.left);
    // Leaves out ends on the boundary: a tie there is a meeting with the boundary edge, tested
    // below.
    if (meeting.at_from && !is_right && !edge_.on_boundary) check_tie(w, edge_.right);
  }

  // Checks a site w that is as near to the Voronoi vertex of triangle t as t's corners.
  void check_tie(vertex_index w, vertex_index t) {
    if (!is_in_polygon(w, t)) {
      tally_.found(finding_kind::voronoi_site_nearer,
                   vertex_text(context_, w) + " is as near to the Voronoi vertex of " +
                       triangle_text(context_, t) +
                       " as its corners, though no triangles with this vertex lead to it");
      return;
    }
    if (!question_.is_wedged_with(w, t))
      tally_.found(finding_kind::voronoi_vertex_missing,
                   vertex_text(context_, w) + " and the ends of the edge between " +
                       vertex_text(context_, edge_.v) + " and " + vertex_text(context_, edge_.u) +
                       " share the Voronoi vertex of " + triangle_text(context_, t) +
                       ", but it is not in all of their wedges");
  }

  bool is_in_polygon(vertex_index w, vertex_index t) {
    const std::vector<vertex_index> corners = voronoi_polygon(context_, tally_, vertices_, t);
    return std::binary_search(corners.begin(), corners.end(), w);
  }

  // Checks that at each point of the boundary edge w is farther than the nearer of the edge's ends.
  // A tie is allowed only in a Voronoi vertex of w.
  void check_boundary(vertex_index w) {
    const site &a = at(edge_.v), &b = at(edge_.u);
    if (is_certainly_farther_than_nearer_end(a, b, at(w))) return;
    if (tally_.kernel().encroaches(a, b, at(w))) return report_boundary(w, " encroaches on ");
    const segment_meeting meeting = meeting_with_segment(a, b, at(w));
    if (meeting == segment_meeting::apart) return;
    const bool at_own_vertex = meeting == segment_meeting::at_middle && edge_.has_ends &&
                               order_ == sign::zero && is_in_polygon(w, edge_.left);
    if (!at_own_vertex) report_boundary(w, " is as near as the ends to a point of ");
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

  void report_nearer(vertex_index w, const std::string& how) {
    tally_.found(finding_kind::voronoi_site_nearer,
                 vertex_text(context_, w) + " " + how + " a point of " + arc_text() + ", beside " +
                     triangle_text(context_, edge_.left) + ", " +
                     (how == "is nearer to" ? "than" : "as") + " they are");
  }

  void report_boundary(vertex_index w, const std::string& how) {
    tally_.found(finding_kind::voronoi_boundary_encroached,
                 vertex_text(context_, w) + how + boundary_text());
  }

  const audit_context& context_;
  audit_tally& tally_;
  const voronoi_vertices& vertices_;
  dual_edge edge_;
  dual_edge_question question_;
  sign order_ = sign::negative;
  std::optional<enclosed_arc> enclosed_;
};

// Checks all arcs of v, except those that a neighbour with a lesser number checks, and the boundary
// edges that leave v.
class cell_check {
 public:
  cell_check(const audit_context& context, audit_tally& tally, const voronoi_vertices& vertices,
             const site_tree& sites)
      : context_(context),
        tally_(tally),
        guard_(context, tally),
        vertices_(vertices),
        sites_(sites) {}

  bool is_over() { return guard_.is_over(); }

  void run(vertex_index v) {
    arcs_.clear();
    double reach = 0;
    for (std::size_t i = context_.edge_start[v]; i < context_.edge_start[v + 1]; ++i) {
      const dual_edge edge = dual_of(context_, vertices_, context_.edges[i]);
      if (!edge.on_boundary && edge.u < edge.v) continue;
      arcs_.emplace_back(context_, tally_, vertices_, edge);
      reach = greatest_bound(reach, arcs_.back().reach());
    }
    if (arcs_.empty()) return;
    sites_.visit_near({context_.subject.sites[v], reach}, [&](vertex_index w) {
      for (arc_check& arc : arcs_)
        if (!guard_.is_over()) arc.run(w);
    });
  }

 private:
  const audit_context& context_;
  audit_tally& tally_;
  audit_work_guard guard_;
  const voronoi_vertices& vertices_;
  const site_tree& sites_;
  std::vector<arc_check> arcs_;  // of the cell at hand; a member to spare allocations
};

}  // namespace

void check_voronoi(audit_context& context) {
  // Counts work from zero: the check of stars does not use up this limit.
  context.looked_units -= audit_units(context.report, context.looked_units);
  context.unfinished = false;
  const auto never = [] { return false; };
  voronoi_vertices vertices(context.subject.triangles.size());
  const auto check_vertices = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    vertex_check part(context, tally, vertices);
    audit_work_guard guard(context, tally);
    for (std::size_t t = begin; t < end && !guard.is_over(); ++t)
      part.run(static_cast<vertex_index>(t));
  };
  bool ended = check_in_parts(context, vertices.size(), check_vertices, never);
  const site_tree& sites = context.plant();
  const std::vector<vertex_index>& order = sites.order();
  const auto check_cells = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    cell_check part(context, tally, vertices, sites);
    for (std::size_t i = begin; i < end && !part.is_over(); ++i) part.run(order[i]);
  };
  ended = ended && check_in_parts(context, order.size(), check_cells, never);
  if (!ended)
    context.found(finding_kind::stopped,
                  unfinished_text(context, "the arcs of the Voronoi diagram"));
  bool refused = false;
  for (const finding_kind kind :
       {finding_kind::voronoi_vertex_missing, finding_kind::voronoi_arc_reversed,
        finding_kind::voronoi_site_nearer, finding_kind::voronoi_boundary_encroached})
    refused = refused || context.report.found[static_cast<std::size_t>(kind)] != 0;
  context.report.voronoi = refused ? voronoi_verdict::refused
                           : ended ? voronoi_verdict::proved
                                   : voronoi_verdict::not_reached;
}

}  // namespace asterism::internal::audit_detail
