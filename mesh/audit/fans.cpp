// SPDX-License-Identifier: MIT
//
// Point 2, seen from each vertex: its triangles surround it once, or fill each sector of the domain
// once; internal edges separate sectors like any others. Implied by the other checks of point 2;
// made all the same, as it names the vertex, and because the star check walks these fans. Requires
// matched edges.
#include <algorithm>

#include "asterism/mesh/audit/context.hpp"

namespace asterism::internal::audit_detail {
namespace {

// The triangle (v, from, to).
struct fan_step {
  vertex_index from = 0, to = 0;
  bool used = false;
};

// Lists the steps sorted by `from`, as the edges are.
void list_steps(const audit_context& context, std::size_t first, std::size_t last,
                std::vector<fan_step>& steps) {
  steps.clear();
  for (std::size_t i = first; i < last; ++i)
    steps.push_back({context.edges[i].b, context.edges[i].apex});
}

// Has the domain at v a sector that starts with the ray to `to`?
bool starts_fan(const audit_context& context, vertex_index v, vertex_index to) {
  return find_subsegment(context, v, to) != context.subject.boundary.size();
}

// Ends where no triangle follows, or at an internal edge.
vertex_fan follow(const audit_context& context, vertex_index v, std::vector<fan_step>& steps,
                  fan_step& start) {
  vertex_fan fan;
  fan.link.reserve(steps.size() + 1);
  fan_step* step = &start;
  while (true) {
    step->used = true;
    fan.link.push_back(step->from);
    const vertex_index to = step->to;
    const auto next =
        std::lower_bound(steps.begin(), steps.end(), to,
                         [](const fan_step& s, vertex_index other) { return s.from < other; });
    if (next == steps.end() || next->from != to || starts_fan(context, v, to)) {
      fan.link.push_back(to);
      return fan;
    }
    if (next->used) {
      fan.closed = true;
      return fan;
    }
    step = &*next;
  }
}

// `steps` is scratch. At a vertex that no boundary edge leaves all steps are one fan nearly always,
// which the first one finds.
std::vector<vertex_fan> fans_around(const audit_context& context, vertex_index v, std::size_t first,
                                    std::size_t last, std::vector<fan_step>& steps) {
  list_steps(context, first, last, steps);
  if (context.side_start[v] == context.side_start[v + 1]) {
    std::vector<vertex_fan> one(1);
    one[0] = follow(context, v, steps, steps[0]);
    if (one[0].closed && one[0].link.size() == steps.size()) return one;
    for (fan_step& s : steps) s.used = false;
  }
  std::vector<vertex_index> arrivals;
  arrivals.reserve(steps.size());
  for (const fan_step& s : steps) arrivals.push_back(s.to);
  std::sort(arrivals.begin(), arrivals.end());
  std::vector<vertex_fan> fans;
  for (fan_step& s : steps)
    if (!std::binary_search(arrivals.begin(), arrivals.end(), s.from) ||
        starts_fan(context, v, s.from))
      fans.push_back(follow(context, v, steps, s));
  for (fan_step& s : steps)
    if (!s.used) fans.push_back(follow(context, v, steps, s));
  return fans;
}

bool in_lower_half(const point& v, const point& p) {
  return p.y < v.y || (p.y == v.y && p.x < v.x);
}

// Counts the full turns of a fan that comes back to its start: each triangle turns by less than a
// half turn, so a turn is completed exactly where a step leads from the lower half plane into the
// upper one.
int turns(const audit_context& context, vertex_index v, const vertex_fan& fan) {
  int count = 0;
  const std::size_t steps = fan.closed ? fan.link.size() : fan.link.size() - 1;
  for (std::size_t i = 0; i < steps; ++i) {
    const vertex_index to = fan.link[(i + 1) % fan.link.size()];
    count += in_lower_half(context.at(v), context.at(fan.link[i])) &&
             !in_lower_half(context.at(v), context.at(to));
  }
  return count;
}

// Does an open fan come round to its first edge again?
bool overturned(const audit_context& context, const filtered_kernel& kernel, vertex_index v,
                const vertex_fan& fan) {
  const point &at_v = context.at(v), &first = context.at(fan.link[0]);
  for (std::size_t i = 1; i + 1 < fan.link.size(); ++i)
    if (kernel.orientation(at_v, context.at(fan.link[i]), first) == sign::positive &&
        kernel.orientation(at_v, first, context.at(fan.link[i + 1])) != sign::negative)
      return true;
  return false;
}

void check_vertex(const audit_context& context, audit_tally& tally, vertex_index v) {
  const std::size_t leaving = context.side_start[v + 1] - context.side_start[v];
  const auto& fans = context.fans[v];
  const auto closed = static_cast<std::size_t>(
      std::count_if(fans.begin(), fans.end(), [](const auto& fan) { return fan.closed; }));
  const std::size_t open = fans.size() - closed;
  if (open != leaving || closed != (leaving == 0 ? 1U : 0U)) {
    tally.found(finding_kind::broken_fan,
                "the triangles at " + vertex_text(context, v) + " form " + std::to_string(closed) +
                    " closed and " + std::to_string(open) + " open fans, with " +
                    std::to_string(leaving) + " boundary edges leaving it");
    return;
  }
  const auto comes_back = [](const vertex_fan& fan) {
    return fan.closed || fan.link.front() == fan.link.back();
  };
  for (const vertex_fan& fan : fans)
    if (comes_back(fan) ? turns(context, v, fan) != 1 : overturned(context, tally.kernel(), v, fan))
      tally.found(finding_kind::broken_fan,
                  "the triangles at " + vertex_text(context, v) + " turn around it more than once");
}

}  // namespace

void check_fans(audit_context& context) {
  context.fans.resize(context.subject.sites.size());
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    std::vector<fan_step> steps;
    for (std::size_t v = begin; v < end; ++v) {
      const std::size_t first = context.edge_start[v], last = context.edge_start[v + 1];
      if (first == last) continue;
      context.fans[v] = fans_around(context, static_cast<vertex_index>(v), first, last, steps);
      check_vertex(context, tally, static_cast<vertex_index>(v));
    }
  };
  check_in_parallel(context, context.fans.size(), check);
}

}  // namespace asterism::internal::audit_detail
