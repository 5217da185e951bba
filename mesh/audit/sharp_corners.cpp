// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/sharp_corners.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace asterism::internal::audit_detail {
namespace {

struct directed_edges {
  std::vector<directed_subsegment> list;  // sorted by a
  std::vector<std::size_t> start;         // as audit_context::side_start
};

directed_edges reversed_sides(const audit_context& context) {
  directed_edges reversed;
  for (const directed_subsegment& side : context.sides)
    reversed.list.push_back({side.b, side.a, side.subsegment});
  std::sort(reversed.list.begin(), reversed.list.end(), [](const auto& l, const auto& r) {
    return std::array{l.a, l.subsegment, l.b} < std::array{r.a, r.subsegment, r.b};
  });
  reversed.start = starts_of(reversed.list, context.subject.sites.size());
  return reversed;
}

// Returns the sectors of the domain at v that are below 180 degrees: each from a subsegment that
// leaves v counter-clockwise to the next one, which reaches v. `arriving` has the sides reversed:
// those that reach v are listed as leaving it.
std::vector<corner> sectors_at(const audit_context& context, const directed_edges& arriving,
                               vertex_index v) {
  std::vector<vertex_index> out, in;
  for (std::size_t i = context.side_start[v]; i < context.side_start[v + 1]; ++i)
    out.push_back(context.sides[i].b);
  for (std::size_t i = arriving.start[v]; i < arriving.start[v + 1]; ++i)
    in.push_back(arriving.list[i].b);
  // Searches all arriving rays once for each leaving one: thousands may meet at v.
  std::vector<corner> sectors;
  for (const vertex_index n : out) {
    std::optional<vertex_index> next;  // on the first ray after that of n
    const auto consider = [&](vertex_index q) {
      if (context.orientation(v, n, q) != sign::positive) return;
      if (!next || context.orientation(v, q, *next) == sign::positive) next = q;
    };
    std::for_each(out.begin(), out.end(), consider);
    std::for_each(in.begin(), in.end(), consider);
    for (const vertex_index p : in)
      if (next && (p == *next || (context.orientation(v, n, p) == sign::positive &&
                                  context.orientation(v, p, *next) == sign::zero)))
        sectors.push_back({v, n, p});
  }
  return sectors;
}

// Returns the narrow sectors of `v`; none if the angle there is not proved to be below the bound.
std::vector<narrow_sector> narrow_sectors(audit_context& context, const directed_edges& arriving,
                                          vertex_index v, const squared_cotangent& bound) {
  std::vector<narrow_sector> narrow;
  audit_tally tally;
  for (const corner& c : sectors_at(context, arriving, v))
    if (is_proven_narrow(context, tally, c, c.at, bound)) narrow.push_back({v, c.ahead, c.behind});
  context.take(std::move(tally));
  return narrow;
}

std::vector<vertex_index> corners_to_prove(const audit_context& context) {
  std::vector<vertex_index> corners = context.options.exempt_corners;
  if (context.options.find_exempt_corners)
    for (const directed_subsegment& side : context.sides)
      // Leaves out vertices that split segments: the boundary is straight there but for rounding.
      if (side.a < context.subject.given) corners.push_back(side.a);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

// Returns the boundary edges from `corner` towards `next`, as far as the next given vertex. `edges`
// are the sides that leave a vertex, or those that reach it, reversed. Empty if the boundary ends
// or branches at a vertex on the way, which another check reports.
std::vector<vertex_index> follow(const audit_context& context,
                                 const std::vector<directed_subsegment>& edges,
                                 const std::vector<std::size_t>& start, vertex_index corner,
                                 vertex_index next) {
  std::vector<vertex_index> chain = {next};
  for (vertex_index from = corner; chain.back() >= context.subject.given;) {
    const vertex_index at = chain.back();
    std::vector<vertex_index> onward;
    for (std::size_t i = start[at]; i < start[at + 1]; ++i)
      if (edges[i].b != from) onward.push_back(edges[i].b);
    if (onward.size() != 1 || chain.size() > edges.size()) return {};
    from = at;
    chain.push_back(onward.front());
  }
  return chain;
}

bool is_internal(const audit_context& context, vertex_index a, vertex_index b) {
  const std::size_t subsegment = find_subsegment(context, a, b);
  return subsegment < context.subject.boundary.size() &&
         context.subject.boundary[subsegment].internal;
}

bool lies_in(const audit_context& context, const filtered_kernel& kernel, const triangle& t,
             const narrow_sector& s) {
  const point &at = context.at(s.at), &first = context.at(s.first), &last = context.at(s.last);
  return std::all_of(t.begin(), t.end(), [&](vertex_index q) {
    return q == s.at || (kernel.orientation(at, first, context.at(q)) != sign::negative &&
                         kernel.orientation(at, context.at(q), last) != sign::negative);
  });
}

}  // namespace

std::vector<narrow_sector> find_narrow_sectors(audit_context& context,
                                               const squared_cotangent& bound) {
  std::vector<vertex_index> claimed = context.options.exempt_corners;
  std::sort(claimed.begin(), claimed.end());
  const directed_edges arriving = reversed_sides(context);
  std::vector<narrow_sector> all;
  for (const vertex_index v : corners_to_prove(context)) {
    std::vector<narrow_sector> narrow;
    if (v < context.measured.size() && context.measured[v])
      narrow = narrow_sectors(context, arriving, v, bound);
    if (!narrow.empty())
      context.report.exempt_corners.push_back(v);
    else if (std::binary_search(claimed.begin(), claimed.end(), v))
      context.found(finding_kind::exemption_not_proven,
                    "the domain's angle at " + vertex_text(context, v) +
                        ", in its own metric, is not below the bound");
    all.insert(all.end(), narrow.begin(), narrow.end());
  }
  return all;
}

narrow_wedges find_narrow_wedges(audit_context& context, const std::vector<narrow_sector>& sectors,
                                 const squared_cotangent& half) {
  narrow_wedges wedges;
  audit_tally tally;
  const directed_edges arriving = reversed_sides(context);
  for (const narrow_sector& s : sectors) {
    if (!is_internal(context, s.at, s.first) && !is_internal(context, s.last, s.at)) continue;
    const auto first = follow(context, context.sides, context.side_start, s.at, s.first);
    const auto last = follow(context, arriving.list, arriving.start, s.at, s.last);
    if (first.empty() || last.empty()) continue;
    const corner whole{s.at, first.back(), last.back()};
    if (context.orientation(whole.at, whole.ahead, whole.behind) != sign::positive) continue;
    if (!is_proven_narrow(context, tally, whole, s.at, half)) continue;
    for (const vertex_index v : first) wedges.points.push_back({v, wedges.list.size(), false});
    for (const vertex_index v : last) wedges.points.push_back({v, wedges.list.size(), true});
    wedges.list.push_back({s.at, first.back(), last.back()});
  }
  context.take(std::move(tally));
  std::sort(wedges.points.begin(), wedges.points.end());
  return wedges;
}

const narrow_sector* sector_of(const audit_context& context, const filtered_kernel& kernel,
                               const triangle& t, vertex_index v,
                               const std::vector<narrow_sector>& sectors) {
  auto s = std::lower_bound(sectors.begin(), sectors.end(), v,
                            [](const narrow_sector& n, vertex_index key) { return n.at < key; });
  while (s != sectors.end() && s->at == v && !lies_in(context, kernel, t, *s)) ++s;
  return s != sectors.end() && s->at == v ? &*s : nullptr;
}

bool crosses_narrow_wedge(const audit_context& context, audit_tally& tally, const triangle& t,
                          const narrow_wedges& wedges, const squared_cotangent& bound) {
  const auto& points = wedges.points;
  const auto is_on = [&](vertex_index v, std::size_t wedge, bool last) {
    return std::binary_search(points.begin(), points.end(), wedge_point{v, wedge, last});
  };
  const vertex_index one = *std::max_element(t.begin(), t.end());
  for (auto p = std::lower_bound(points.begin(), points.end(), wedge_point{one, 0, false});
       p != points.end() && p->vertex == one; ++p) {
    const narrow_wedge& w = wedges.list[p->wedge];
    const bool across = std::any_of(t.begin(), t.end(),
                                    [&](vertex_index v) { return is_on(v, p->wedge, !p->last); });
    const bool within = std::all_of(t.begin(), t.end(), [&](vertex_index v) {
      return v == w.at || is_on(v, p->wedge, false) || is_on(v, p->wedge, true);
    });
    if (across && within && std::all_of(t.begin(), t.end(), [&](vertex_index v) {
          return is_proven_narrow(context, tally, {w.at, w.first_end, w.last_end}, v, bound);
        }))
      return true;
  }
  return false;
}

}  // namespace asterism::internal::audit_detail
