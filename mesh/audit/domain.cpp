// SPDX-License-Identifier: MIT
//
// Point 2 against the domain that was meshed: its vertices are kept bit for bit, and the boundary
// is its segments, each cut into subsegments that lead from its start to its end.
//
// A split point is a rounded point, so the subsegments need not lie on the segment exactly: the
// largest distance is reported, and refused when rounding cannot explain it.
#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/checks.hpp"
#include "asterism/mesh/audit/curves.hpp"
#include "asterism/mesh/audit/roots.hpp"

namespace asterism::internal::audit_detail {
namespace {

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
  for (vertex_index v = 0; v < m.given; ++v) {
    if (same_bits(m.sites[v].position, vertices[v])) continue;
    kept = false;
    context.found(finding_kind::given_changed, vertex_text(context, v) + " was given at (" +
                                                   number_text(vertices[v].x) + ", " +
                                                   number_text(vertices[v].y) + ")");
  }
  return kept;
}

// The boundary subsegments from one given vertex to the next, in order.
struct chain {
  vertex_index start = 0, end = 0;
  std::vector<vertex_index> subsegments;
};

std::vector<chain> chains_of(const audit_context& context, vertex_index given) {
  const auto& boundary = context.subject.boundary;
  std::vector<std::vector<vertex_index>> leaving(context.subject.sites.size());
  for (const vertex_index subsegment : context.subsegments)
    leaving[boundary[subsegment].a].push_back(subsegment);
  std::vector<chain> chains;
  for (vertex_index v = 0; v < given; ++v)
    for (const vertex_index first : leaving[v]) {
      chain c{v, boundary[first].b, {first}};
      // Bounds the walk by the number of edges: the boundary of a damaged mesh may close without a
      // given vertex.
      while (c.end >= given && leaving[c.end].size() == 1 &&
             c.subsegments.size() <= boundary.size()) {
        c.subsegments.push_back(leaving[c.end].front());
        c.end = boundary[c.subsegments.back()].b;
      }
      chains.push_back(std::move(c));
    }
  return chains;
}

// True if rounding can explain the distance of a split point from its segment. Each coordinate of a
// point computed on the line of two others, and rounded once or twice, has an error below one and a
// half units in the last place, whatever the segment's length: two units for both coordinates.
// The two others may be split points themselves, whose errors add up, a unit for each of at most
// sixteen levels. Such a sum is allowed only if it is a tiny part of the segment's length too, so
// that no side of the domain can vanish in it.
bool is_explained(double distance, double ulp, const vector2<rational>& along) {
  constexpr double always = 2, at_most = 16, part_of_length = 0x1p-10;
  if (distance <= always * ulp) return true;
  const rational part = rational(part_of_length) * rational(part_of_length) * dot(along, along);
  return distance <= at_most * ulp && rational(distance) * rational(distance) <= part;
}

// True if the segment from a to b is along an axis, p and q are exactly on its line, and q is
// farther along it. Comparisons of coordinates decide all of that.
bool goes_along_axis(const point& a, const point& b, const point& p, const point& q) {
  if (a.x == b.x && p.x == a.x && q.x == a.x) return a.y < b.y ? p.y < q.y : b.y < a.y && q.y < p.y;
  return a.y == b.y && p.y == a.y && q.y == a.y && (a.x < b.x ? p.x < q.x : b.x < a.x && q.x < p.x);
}

// Checks that a part of the boundary, from one vertex on a segment or curve to the next, is
// straight but for rounding.
void check_straight(audit_context& context, const std::vector<vertex_index>& along) {
  const vertex_index start = along.front(), end = along.back();
  const point& a = context.at(start);
  const point& b = context.at(end);
  if (along.size() == 2 && !(a == b)) return;  // one subsegment, which is the segment
  const vector2<rational> along_segment = difference<rational>(b, a);
  const double reach = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
  const double ulp = unit_in_last_place(reach);
  const std::string whole =
      "segment from " + vertex_text(context, start) + " to " + vertex_text(context, end);
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    if (goes_along_axis(a, b, context.at(along[i]), context.at(along[i + 1]))) {
      const bool is_last = i + 2 == along.size();  // the end of the segment is on it
      context.report.decisions += is_last ? 0 : 1;
      context.report.exact_decisions += is_last ? 0 : 1;
      continue;
    }
    const vector2<rational> forward =
        difference<rational>(context.at(along[i + 1]), context.at(along[i]));
    if (dot(forward, along_segment) <= 0)
      context.found(finding_kind::segment_not_covered,
                    "from " + vertex_text(context, along[i]) + " to " +
                        vertex_text(context, along[i + 1]) + " the boundary runs against its " +
                        whole);
    if (i + 2 == along.size()) continue;
    const rational offset = cross(along_segment, difference<rational>(context.at(along[i + 1]), a));
    const double distance = root_rounded_up(offset * offset / dot(along_segment, along_segment));
    context.report.decisions += 1;
    context.report.exact_decisions += 1;
    context.report.largest_deviation = std::max(context.report.largest_deviation, distance);
    context.report.largest_deviation_ulps =
        std::max(context.report.largest_deviation_ulps, distance / ulp);
    if (!is_explained(distance, ulp, along_segment))
      context.found(finding_kind::boundary_deviation,
                    vertex_text(context, along[i + 1]) + " is up to " + number_text(distance) +
                        ", " + number_text(distance / ulp) +
                        " units in the last place, away from the " + whole);
  }
}

// Returns the vertices along a chain, its two ends included.
std::vector<vertex_index> vertices_along(const audit_context& context, const chain& c) {
  std::vector<vertex_index> along{c.start};
  for (const vertex_index subsegment : c.subsegments)
    along.push_back(context.subject.boundary[subsegment].b);
  return along;
}

void check_subsegment(audit_context& context, vertex_index subsegment, const segment& s) {
  const boundary_edge& e = context.subject.boundary[subsegment];
  if (e.marker != s.marker)
    context.found(finding_kind::marker_changed,
                  subsegment_text(context, subsegment) + " has marker " + std::to_string(e.marker) +
                      ", its segment has " + std::to_string(s.marker));
  if (e.internal != s.internal)
    context.found(finding_kind::side_changed,
                  subsegment_text(context, subsegment) + " has the domain on " +
                      (e.internal ? "both sides" : "one side") + ", its segment on " +
                      (s.internal ? "both" : "one"));
}

std::string segment_text(const audit_context& context, vertex_index s) {
  const segment& seg = context.options.original->segments[s];
  return "segment " + number_of(context, s) + " from " + vertex_text(context, seg.a) + " to " +
         vertex_text(context, seg.b);
}

// Matches each chain with the segment that has the same ends; two segments cannot share both.
void match_chains(audit_context& context, std::vector<chain> chains) {
  const auto& segments = context.options.original->segments;
  std::sort(chains.begin(), chains.end(), [](const chain& l, const chain& r) {
    return std::array{l.start, l.end} < std::array{r.start, r.end};
  });
  std::vector<char> taken(chains.size(), 0);
  curve_audit curves(context);
  for (vertex_index s = 0; s < segments.size(); ++s) {
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
    const std::vector<vertex_index> along = vertices_along(context, *c);
    const auto straight = [&](const auto& part) { check_straight(context, part); };
    if (!curves.judge(along, straight)) straight(along);
    for (const vertex_index subsegment : c->subsegments) {
      check_subsegment(context, subsegment, segments[s]);
      context.segment_of[subsegment] = s;
    }
  }
  curves.finish();
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (!taken[i])
      context.found(finding_kind::segment_not_covered,
                    subsegment_text(context, chains[i].subsegments.front()) +
                        " and what follows it up to " + vertex_text(context, chains[i].end) +
                        " belong to no segment");
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
  for (const chain& c : chains) covered += c.subsegments.size();
  match_chains(context, std::move(chains));
  if (covered != context.subsegments.size())
    context.found(finding_kind::segment_not_covered,
                  std::to_string(context.subsegments.size()) + " boundary edges, " +
                      std::to_string(covered) + " of them between given vertices");
}

}  // namespace asterism::internal::audit_detail
