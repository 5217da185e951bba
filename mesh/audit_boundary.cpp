// SPDX-License-Identifier: MIT
//
// Point 2, the geometric part: the boundary is simple and encloses its left side exactly once.
// Internal edges are no part of the boundary here: they bound nothing, their two sides cancel out.
#include <algorithm>
#include <limits>

#include "asterism/mesh/audit_context.hpp"
#include "asterism/mesh/audit_piece_tree.hpp"

namespace asterism::audit_detail {
namespace {

// Do closed segments with no common end, whose boxes overlap, have a common point?
bool segments_meet(const audit_context& context, const boundary_edge& e, const boundary_edge& f) {
  const sign fa = context.orientation(e.a, e.b, f.a);
  const sign fb = context.orientation(e.a, e.b, f.b);
  if (fa * fb == sign::positive) return false;
  const sign ea = context.orientation(f.a, f.b, e.a);
  const sign eb = context.orientation(f.a, f.b, e.b);
  // All four zero: on one line, where overlapping boxes mean overlapping segments.
  return ea * eb != sign::positive;
}

// Segments shared-p and shared-q: one point in common, or a stretch?
bool overlap_from(const audit_context& context, index shared, index p, index q) {
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

// How often the boundary winds around the points just left of the middle of `piece`, counted along
// the ray from there to x = +infinity. Requires a boundary without contacts.
//
// The ray starts an infinitesimal above the height of the middle, except left of a piece that runs
// exactly towards -x, where the left side is below: `below` then moves every tie the other way.
int winding_left_of(const audit_context& context, const piece_tree& tree, index piece) {
  const auto& boundary = context.subject.boundary;
  const point& a = context.at(boundary[piece].a);
  const point& b = context.at(boundary[piece].b);
  const vector2<rational> middle = {(rational(a.x) + rational(b.x)) / 2,
                                    (rational(a.y) + rational(b.y)) / 2};
  const bool below = a.y == b.y && b.x < a.x;
  const auto under = [&](const point& p) {
    const rational y(p.y);
    return below ? y < middle.y : y <= middle.y;
  };
  int winding = 0;
  const auto count = [&](index other) {
    if (boundary[other].internal) return true;
    const point& c = context.at(boundary[other].a);
    const point& d = context.at(boundary[other].b);
    const bool upward = under(c) && !under(d);
    const bool downward = under(d) && !under(c);
    if (!upward && !downward) return true;
    const vector2<rational> along = {rational(d.x) - rational(c.x), rational(d.y) - rational(c.y)};
    const vector2<rational> reach = {middle.x - rational(c.x), middle.y - rational(c.y)};
    // The piece itself has its own left side on its left.
    const int side = other == piece ? 1 : cross(along, reach).sign();
    if (upward && side > 0) ++winding;
    if (downward && side < 0) --winding;
    return true;
  };
  // Whatever meets the ray has its box meet this one.
  const plane_box own = box_around(a, b);
  tree.visit({own.low, {std::numeric_limits<double>::infinity(), own.high.y}}, count);
  return winding;
}

void check_piece_winding(audit_context& context, const piece_tree& tree, index piece) {
  const int winding = winding_left_of(context, tree, piece);
  ++context.report.decisions;
  ++context.report.exact_decisions;
  if (winding != 1)
    context.found(finding_kind::wrong_winding,
                  "the boundary winds " + std::to_string(winding) +
                      " times instead of once around the left side of " +
                      piece_text(context, piece));
}

}  // namespace

void check_boundary_contacts(audit_context& context) {
  const auto& boundary = context.subject.boundary;
  const piece_tree tree(context);
  for (const index piece : context.pieces) {
    const boundary_edge& e = boundary[piece];
    std::vector<index> met;
    tree.visit(box_around(context.at(e.a), context.at(e.b)), [&](index other) {
      if (other < piece && contact(context, e, boundary[other])) met.push_back(other);
      return true;
    });
    std::sort(met.begin(), met.end());
    for (const index other : met)
      context.found(
          finding_kind::boundary_contact,
          piece_text(context, piece) + " crosses or touches " + piece_text(context, other));
  }
}

// Along a chain of pieces through vertices with one piece in and one out, the left sides belong to
// one face of the plane cut along the boundary: one piece of each chain is enough.
void check_winding(audit_context& context) {
  const auto& boundary = context.subject.boundary;
  std::vector<std::vector<index>> leaving(context.subject.sites.size());
  for (const index piece : context.pieces)
    if (!boundary[piece].internal) leaving[boundary[piece].a].push_back(piece);
  std::vector<char> seen(boundary.size(), 0);
  const piece_tree tree(context);
  const auto walk = [&](index piece) {
    check_piece_winding(context, tree, piece);
    while (!seen[piece]) {
      seen[piece] = 1;
      const auto& next = leaving[boundary[piece].b];
      if (next.size() != 1) break;
      piece = next.front();
    }
  };
  for (const auto& pieces : leaving)
    if (pieces.size() > 1)
      for (const index piece : pieces) walk(piece);
  for (const index piece : context.pieces)
    if (!seen[piece] && !boundary[piece].internal) walk(piece);
}

}  // namespace asterism::audit_detail
