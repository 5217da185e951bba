// SPDX-License-Identifier: MIT
//
// Point 2, the geometric part: the boundary is simple and encloses its left side exactly once.
// Internal edges are no part of the boundary here: they bound nothing, their two sides cancel out.
#include <algorithm>
#include <limits>

#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/subsegment_tree.hpp"

namespace asterism::internal::audit_detail {
namespace {

// True if closed segments with no common end, whose boxes overlap, have a common point.
bool segments_meet(const audit_context& context, const boundary_edge& e, const boundary_edge& f) {
  const sign fa = context.orientation(e.a, e.b, f.a);
  const sign fb = context.orientation(e.a, e.b, f.b);
  if (fa * fb == sign::positive) return false;
  const sign ea = context.orientation(f.a, f.b, e.a);
  const sign eb = context.orientation(f.a, f.b, e.b);
  // Four zero signs mean that both segments are on one line, where overlapping boxes mean
  // overlapping segments.
  return ea * eb != sign::positive;
}

// True if the segments from `shared` to p and from `shared` to q have more than that one point in
// common, which needs one direction for both.
bool overlap_from(const audit_context& context, vertex_index shared, vertex_index p,
                  vertex_index q) {
  return context.orientation(shared, p, q) == sign::zero &&
         same_ray(context.at(shared), context.at(p), context.at(q));
}

bool contact(const audit_context& context, const boundary_edge& e, const boundary_edge& f) {
  if ((e.a == f.a && e.b == f.b) || (e.a == f.b && e.b == f.a)) return true;
  if (e.a == f.a) return overlap_from(context, e.a, e.b, f.b);
  if (e.a == f.b) return overlap_from(context, e.a, e.b, f.a);
  if (e.b == f.a) return overlap_from(context, e.b, e.a, f.b);
  if (e.b == f.b) return overlap_from(context, e.b, e.a, f.a);
  return segments_meet(context, e, f);
}

// Returns how often the boundary winds around the points just left of the middle of `subsegment`,
// counted along the ray from there to x = +infinity. Requires a boundary without contacts.
//
// The ray starts an infinitesimal above the height of the middle, except left of a subsegment that
// runs exactly towards -x, where the left side is below: `below` then moves every tie the other
// way.
int winding_left_of(const audit_context& context, const subsegment_tree& tree,
                    vertex_index subsegment) {
  const auto& boundary = context.subject.boundary;
  const point& a = context.at(boundary[subsegment].a);
  const point& b = context.at(boundary[subsegment].b);
  const vector2<rational> middle = {(rational(a.x) + rational(b.x)) / 2,
                                    (rational(a.y) + rational(b.y)) / 2};
  const bool below = a.y == b.y && b.x < a.x;
  const auto under = [&](const point& p) {
    const rational y(p.y);
    return below ? y < middle.y : y <= middle.y;
  };
  int winding = 0;
  const auto count = [&](vertex_index other) {
    if (boundary[other].internal) return true;
    const point& c = context.at(boundary[other].a);
    const point& d = context.at(boundary[other].b);
    const bool upward = under(c) && !under(d);
    const bool downward = under(d) && !under(c);
    if (!upward && !downward) return true;
    const vector2<rational> along = {rational(d.x) - rational(c.x), rational(d.y) - rational(c.y)};
    const vector2<rational> reach = {middle.x - rational(c.x), middle.y - rational(c.y)};
    // Treats the subsegment itself as having the start of the ray on its left.
    const int side = other == subsegment ? 1 : cross(along, reach).sign();
    if (upward && side > 0) ++winding;
    if (downward && side < 0) --winding;
    return true;
  };
  // Visits all subsegments that may meet the ray: their boxes meet the box of the ray.
  const plane_box own = box_around(a, b);
  tree.visit({own.low, {std::numeric_limits<double>::infinity(), own.high.y}}, count);
  return winding;
}

void check_subsegment_winding(audit_context& context, const subsegment_tree& tree,
                              vertex_index subsegment) {
  const int winding = winding_left_of(context, tree, subsegment);
  ++context.report.decisions;
  ++context.report.exact_decisions;
  if (winding != 1)
    context.found(finding_kind::wrong_winding,
                  "the boundary winds " + std::to_string(winding) +
                      " times instead of once around the left side of " +
                      subsegment_text(context, subsegment));
}

}  // namespace

void check_boundary_contacts(audit_context& context) {
  const auto& boundary = context.subject.boundary;
  const subsegment_tree tree(context);
  for (const vertex_index subsegment : context.subsegments) {
    const boundary_edge& e = boundary[subsegment];
    std::vector<vertex_index> met;
    tree.visit(box_around(context.at(e.a), context.at(e.b)), [&](vertex_index other) {
      if (other < subsegment && contact(context, e, boundary[other])) met.push_back(other);
      return true;
    });
    std::sort(met.begin(), met.end());
    for (const vertex_index other : met)
      context.found(finding_kind::boundary_contact, subsegment_text(context, subsegment) +
                                                        " crosses or touches " +
                                                        subsegment_text(context, other));
  }
}

// Checks the winding number once for each chain of subsegments through vertices with one subsegment
// in and one out: the left sides along a chain belong to one face of the plane cut along the
// boundary.
void check_winding(audit_context& context) {
  const auto& boundary = context.subject.boundary;
  std::vector<std::vector<vertex_index>> leaving(context.subject.sites.size());
  for (const vertex_index subsegment : context.subsegments)
    if (!boundary[subsegment].internal) leaving[boundary[subsegment].a].push_back(subsegment);
  std::vector<char> seen(boundary.size(), 0);
  const subsegment_tree tree(context);
  const auto walk = [&](vertex_index subsegment) {
    check_subsegment_winding(context, tree, subsegment);
    while (!seen[subsegment]) {
      seen[subsegment] = 1;
      const auto& next = leaving[boundary[subsegment].b];
      if (next.size() != 1) break;
      subsegment = next.front();
    }
  };
  for (const auto& subsegments : leaving)
    if (subsegments.size() > 1)
      for (const vertex_index subsegment : subsegments) walk(subsegment);
  for (const vertex_index subsegment : context.subsegments)
    if (!seen[subsegment] && !boundary[subsegment].internal) walk(subsegment);
}

}  // namespace asterism::internal::audit_detail
