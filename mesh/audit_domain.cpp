// SPDX-License-Identifier: MIT
//
// Point 2 against the domain that was meshed: its vertices are kept bit for bit, and the boundary
// is its segments, each cut into pieces that lead from its start to its end.
//
// A split point is a rounded point, so the pieces need not lie on the segment exactly: the largest
// distance is reported, and refused when rounding cannot explain it.
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "asterism/mesh/audit_context.hpp"

namespace asterism::audit_detail {
namespace {

bool same_bits(const point& a, const point& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y);
}

bool check_given(audit_context& context) {
  const mesh& m = context.subject;
  const auto& vertices = context.options.original->vertices;
  if (m.given != vertices.size() || m.given > m.sites.size()) {
    context.found(finding_kind::given_changed, std::to_string(m.given) +
                                                   " vertices are kept as given, the domain has " +
                                                   std::to_string(vertices.size()));
    return false;
  }
  bool kept = true;
  for (index v = 0; v < m.given; ++v) {
    if (same_bits(m.sites[v].position, vertices[v])) continue;
    kept = false;
    context.found(finding_kind::given_changed, vertex_text(context, v) + " was given at (" +
                                                   number_text(vertices[v].x) + ", " +
                                                   number_text(vertices[v].y) + ")");
  }
  return kept;
}

// The pieces from one given vertex to the next along the boundary.
struct chain {
  index start = 0, end = 0;
  std::vector<index> pieces;
};

std::vector<chain> chains_of(const audit_context& context, index given) {
  const auto& boundary = context.subject.boundary;
  std::vector<std::vector<index>> leaving(context.subject.sites.size());
  for (const index piece : context.pieces) leaving[boundary[piece].a].push_back(piece);
  std::vector<chain> chains;
  for (index v = 0; v < given; ++v)
    for (const index first : leaving[v]) {
      chain c{v, boundary[first].b, {first}};
      // Bounded: a damaged mesh may go round without ever meeting a given vertex.
      while (c.end >= given && leaving[c.end].size() == 1 && c.pieces.size() <= boundary.size()) {
        c.pieces.push_back(leaving[c.end].front());
        c.end = boundary[c.pieces.back()].b;
      }
      chains.push_back(std::move(c));
    }
  return chains;
}

// An upper bound of sqrt(square), as a double; infinity where that overflows.
double root_rounded_up(const rational& square) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, square.backend().data(), MPFR_RNDU);
  mpfr_sqrt(value, value, MPFR_RNDU);
  const double result = mpfr_get_d(value, MPFR_RNDU);
  mpfr_clear(value);
  return result;
}

void check_split_points(audit_context& context, const chain& c) {
  const point& a = context.at(c.start);
  const point& b = context.at(c.end);
  const vector2<rational> along = difference<rational>(b, a);
  const double reach = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  for (const index piece : c.pieces) {
    const boundary_edge& e = context.subject.boundary[piece];
    const vector2<rational> forward = difference<rational>(context.at(e.b), context.at(e.a));
    if (dot(forward, along) <= 0)
      context.found(finding_kind::segment_not_covered,
                    piece_text(context, piece) + " runs against its segment from " +
                        vertex_text(context, c.start) + " to " + vertex_text(context, c.end));
    if (e.b == c.end) continue;
    const rational offset = cross(along, difference<rational>(context.at(e.b), a));
    const double distance = root_rounded_up(offset * offset / dot(along, along));
    context.report.decisions += 1;
    context.report.exact_decisions += 1;
    context.report.largest_deviation = std::max(context.report.largest_deviation, distance);
    if (!(distance <= context.options.deviation_limit * reach))
      context.found(finding_kind::boundary_deviation,
                    vertex_text(context, e.b) + " is up to " + number_text(distance) +
                        " away from the segment from " + vertex_text(context, c.start) + " to " +
                        vertex_text(context, c.end));
  }
}

void check_piece(audit_context& context, index piece, const segment& s) {
  const boundary_edge& e = context.subject.boundary[piece];
  if (e.marker != s.marker)
    context.found(finding_kind::marker_changed,
                  piece_text(context, piece) + " has marker " + std::to_string(e.marker) +
                      ", its segment has " + std::to_string(s.marker));
  if (e.internal != s.internal)
    context.found(finding_kind::side_changed, piece_text(context, piece) + " has the domain on " +
                                                  (e.internal ? "both sides" : "one side") +
                                                  ", its segment on " +
                                                  (s.internal ? "both" : "one"));
}

std::string segment_text(const audit_context& context, index s) {
  const segment& seg = context.options.original->segments[s];
  return "segment " + std::to_string(std::size_t{s} + 1) + " from " + vertex_text(context, seg.a) +
         " to " + vertex_text(context, seg.b);
}

// Chains and segments are matched by their ends, which two segments cannot share.
void match_chains(audit_context& context, std::vector<chain> chains) {
  const auto& segments = context.options.original->segments;
  std::sort(chains.begin(), chains.end(), [](const chain& l, const chain& r) {
    return std::array{l.start, l.end} < std::array{r.start, r.end};
  });
  std::vector<char> taken(chains.size(), 0);
  for (index s = 0; s < segments.size(); ++s) {
    const std::array ends{segments[s].a, segments[s].b};
    const auto c =
        std::lower_bound(chains.begin(), chains.end(), ends, [](const chain& l, const auto& key) {
          return std::array{l.start, l.end} < key;
        });
    const auto place = static_cast<std::size_t>(c - chains.begin());
    if (c == chains.end() || std::array{c->start, c->end} != ends || taken[place]) {
      context.found(finding_kind::segment_not_covered,
                    "no chain of boundary edges is " + segment_text(context, s));
      continue;
    }
    taken[place] = 1;
    check_split_points(context, *c);
    for (const index piece : c->pieces) {
      check_piece(context, piece, segments[s]);
      context.segment_of[piece] = s;
    }
  }
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (!taken[i])
      context.found(finding_kind::segment_not_covered,
                    piece_text(context, chains[i].pieces.front()) + " and what follows it up to " +
                        vertex_text(context, chains[i].end) + " belong to no segment");
}

}  // namespace

void check_domain_kept(audit_context& context) {
  context.report.domain_checked = true;
  context.segment_of.assign(context.subject.boundary.size(), std::nullopt);
  const domain& original = *context.options.original;
  if (!check_given(context)) return;
  for (const segment& s : original.segments)
    if (s.a >= original.vertices.size() || s.b >= original.vertices.size()) {
      context.found(finding_kind::invalid_option,
                    "the domain has a segment that names a vertex it does not have");
      return;
    }
  if (std::find(context.placed.begin(), context.placed.end(), 0) != context.placed.end()) return;
  std::vector<chain> chains = chains_of(context, context.subject.given);
  std::size_t covered = 0;
  for (const chain& c : chains) covered += c.pieces.size();
  match_chains(context, std::move(chains));
  if (covered != context.pieces.size())
    context.found(finding_kind::segment_not_covered,
                  std::to_string(context.pieces.size()) + " boundary edges, " +
                      std::to_string(covered) + " of them between given vertices");
}

}  // namespace asterism::audit_detail
