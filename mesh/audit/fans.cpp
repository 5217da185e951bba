// SPDX-License-Identifier: MIT
//
// Point 2, seen from each vertex: its triangles surround it once, or fill each sector of the
// domain once; internal edges separate sectors like any others. The other checks of point 2 imply
// it; this one names the vertex, and makes the fans for the check of stars. Requires matched
// edges.
#include <algorithm>
#include <cstddef>

#include "asterism/mesh/audit/checks.hpp"

namespace asterism::internal::audit_detail {
namespace {

// One triangle (v, from, to) of a fan around v.
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

// Returns the step that begins at `from`, or the end of the list. Searches a short list linearly,
// as a bisection is mispredicted at every second step.
std::vector<fan_step>::iterator step_from(std::vector<fan_step>& steps, vertex_index from) {
  constexpr std::size_t most_compared = 16;
  auto next = steps.begin();
  if (steps.size() > most_compared)
    next = std::lower_bound(steps.begin(), steps.end(), from,
                            [](const fan_step& s, vertex_index other) { return s.from < other; });
  else
    for (const fan_step& s : steps) next += static_cast<std::ptrdiff_t>(s.from < from);
  return next != steps.end() && next->from == from ? next : steps.end();
}

// True if the domain has a sector at v that starts with the ray to `to`.
bool starts_fan(const audit_context& context, vertex_index v, vertex_index to) {
  return find_subsegment(context, v, to) != context.subject.boundary.size();
}

// Adds one fan to the block. Ends where no triangle follows, or at an internal edge.
void follow(const audit_context& context, vertex_index v, std::vector<fan_step>& steps,
            fan_step& start, fan_lists::block& to) {
  const auto end_fan = [&to](bool closed) {
    to.fans.push_back({closed, static_cast<std::uint32_t>(to.links.size())});
  };
  fan_step* step = &start;
  while (true) {
    step->used = true;
    to.links.push_back(step->from);
    const vertex_index last = step->to;
    const auto next = step_from(steps, last);
    if (next == steps.end() || starts_fan(context, v, last)) {
      to.links.push_back(last);
      return end_fan(false);
    }
    if (next->used) return end_fan(true);
    step = &*next;
  }
}

// Adds all fans around v to the block; `steps` is scratch. At a vertex that no boundary edge
// leaves, the first fan usually takes all steps.
void list_fans(const audit_context& context, vertex_index v, std::size_t first, std::size_t last,
               std::vector<fan_step>& steps, fan_lists::block& to) {
  list_steps(context, first, last, steps);
  if (context.side_start[v] == context.side_start[v + 1]) {
    const std::size_t fans = to.fans.size(), links = to.links.size();
    follow(context, v, steps, steps[0], to);
    if (to.fans.back().closed && to.links.size() - links == steps.size()) return;
    to.fans.resize(fans);
    to.links.resize(links);
    for (fan_step& s : steps) s.used = false;
  }
  std::vector<vertex_index> arrivals;
  arrivals.reserve(steps.size());
  for (const fan_step& s : steps) arrivals.push_back(s.to);
  std::sort(arrivals.begin(), arrivals.end());
  for (fan_step& s : steps)
    if (!std::binary_search(arrivals.begin(), arrivals.end(), s.from) ||
        starts_fan(context, v, s.from))
      follow(context, v, steps, s, to);
  for (fan_step& s : steps)
    if (!s.used) follow(context, v, steps, s, to);
}

// Returns 1 if p is below v, or level with it and to the left. Has no branch, which would be
// mispredicted.
int in_lower_half(const point& v, const point& p) {
  return static_cast<int>(p.y < v.y) | (static_cast<int>(p.y == v.y) & static_cast<int>(p.x < v.x));
}

// Returns the number of full turns of a closed fan: each triangle turns by less than a half
// turn, so a turn is completed exactly where a step leads from the lower half plane into the
// upper one.
int turns(const audit_context& context, vertex_index v, const vertex_fan& fan) {
  const point at_v = context.at(v);
  int count = 0, was_lower = in_lower_half(at_v, context.at(fan.link.front()));
  const int first = was_lower;
  for (std::size_t i = 1; i < fan.link.size(); ++i) {
    const int is_lower = in_lower_half(at_v, context.at(fan.link[i]));
    count += was_lower & (1 - is_lower);
    was_lower = is_lower;
  }
  return fan.closed ? count + (was_lower & (1 - first)) : count;
}

// True if an open fan reaches its first edge again.
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
  std::size_t closed = 0, open = 0;
  context.fans.visit(v, [&](const vertex_fan& fan) { ++(fan.closed ? closed : open); });
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
  context.fans.visit(v, [&](const vertex_fan& fan) {
    if (comes_back(fan) ? turns(context, v, fan) != 1 : overturned(context, tally.kernel(), v, fan))
      tally.found(finding_kind::broken_fan,
                  "the triangles at " + vertex_text(context, v) + " turn around it more than once");
  });
}

// Adds the fans of the vertices from `begin` to `end`, those of one block, to the block, which is
// empty, and checks them.
void make_block(audit_context& context, audit_tally& tally, std::size_t begin, std::size_t end) {
  std::vector<fan_step> steps;
  for (std::size_t v = begin; v < end; ++v) {
    context.prefetch_around(v + sites_ahead);
    const auto at = static_cast<vertex_index>(v);
    const std::size_t first = context.edge_start[v], last = context.edge_start[v + 1];
    fan_lists::block& to = context.fans.block_of(at);
    if (first != last) list_fans(context, at, first, last, steps, to);
    to.ends.push_back(static_cast<std::uint32_t>(to.fans.size()));
    if (first != last) check_vertex(context, tally, at);
  }
}

}  // namespace

void check_fans(audit_context& context) {
  context.fans.resize(context.subject.sites.size());
  const auto check = [&](audit_tally& tally, std::size_t begin, std::size_t end) {
    make_block(context, tally, begin, end);
  };
  check_in_parallel(context, context.subject.sites.size(), check, fan_lists::vertices_of_a_block);
}

void check_fans_again(audit_context& context, const triangulation_changes& changes) {
  constexpr std::size_t size = fan_lists::vertices_of_a_block;
  std::vector<std::size_t> blocks;
  for (const vertex_index v : changes.corners)
    if (blocks.empty() || blocks.back() != v / size) blocks.push_back(v / size);
  const auto check = [&](audit_tally& tally, std::size_t nth, std::size_t) {
    const std::size_t begin = size * blocks[nth];
    context.fans.block_of(static_cast<vertex_index>(begin)) = {};
    make_block(context, tally, begin, std::min(begin + size, context.subject.sites.size()));
  };
  check_in_parallel(context, blocks.size(), check, 1);
}

}  // namespace asterism::internal::audit_detail
