// SPDX-License-Identifier: MIT
//
// Point 2, the geometric part: the boundary is simple and encloses its left side exactly once.
// Internal edges are no part of the boundary here: they bound nothing, their two sides cancel out.
#include <algorithm>

#include "asterism/mesh/audit_context.hpp"

namespace asterism::audit_detail {
namespace {

struct span {
  double low_x, high_x, low_y, high_y;
  index piece;
};

span span_of(const audit_context& context, index piece) {
  const point& a = context.at(context.subject.boundary[piece].a);
  const point& b = context.at(context.subject.boundary[piece].b);
  return {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y), piece};
}

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
int winding_left_of(const audit_context& context, index piece) {
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
  for (const index other : context.pieces) {
    if (boundary[other].internal) continue;
    const point& c = context.at(boundary[other].a);
    const point& d = context.at(boundary[other].b);
    const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
    if (std::max(c.y, d.y) < low || std::min(c.y, d.y) > high) continue;
    const bool upward = under(c) && !under(d);
    const bool downward = under(d) && !under(c);
    if (!upward && !downward) continue;
    const vector2<rational> along = {rational(d.x) - rational(c.x), rational(d.y) - rational(c.y)};
    const vector2<rational> reach = {middle.x - rational(c.x), middle.y - rational(c.y)};
    // The piece itself has its own left side on its left.
    const int side = other == piece ? 1 : cross(along, reach).sign();
    if (upward && side > 0) ++winding;
    if (downward && side < 0) --winding;
  }
  return winding;
}

void check_piece_winding(audit_context& context, index piece) {
  const int winding = winding_left_of(context, piece);
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
  std::vector<span> spans;
  for (const index piece : context.pieces) spans.push_back(span_of(context, piece));
  std::sort(spans.begin(), spans.end(), [](const span& l, const span& r) {
    return l.low_x < r.low_x || (l.low_x == r.low_x && l.piece < r.piece);
  });
  const auto& boundary = context.subject.boundary;
  std::vector<span> active;  // those whose x range reaches the current one
  for (const span& s : spans) {
    std::erase_if(active, [&](const span& other) { return other.high_x < s.low_x; });
    for (const span& other : active) {
      if (other.high_y < s.low_y || s.high_y < other.low_y) continue;
      if (contact(context, boundary[s.piece], boundary[other.piece]))
        context.found(finding_kind::boundary_contact, piece_text(context, s.piece) +
                                                          " crosses or touches " +
                                                          piece_text(context, other.piece));
    }
    active.push_back(s);
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
  const auto walk = [&](index piece) {
    check_piece_winding(context, piece);
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
