// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/voronoi_arc_candidates.hpp"

#include <algorithm>

#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {

std::vector<point> arc_candidates(const refine_state& state, const triangle& t) {
  const auto& sites = state.sites();
  std::vector<point> candidates;
  if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    candidates = voronoi_vertices(sites[t[0]], sites[t[1]], sites[t[2]]);
  for (std::size_t i = 0; i < 3; ++i) {
    const vertex_index v = t[i], w = t[(i + 1) % 3];
    if (v == w) continue;
    for (const point& q : wedge_exits(sites[v], sites[w])) candidates.push_back(q);
  }
  return candidates;
}

bool refine_by_arcs(refine_state& state, const triangle& t, double tolerance,
                    std::size_t& rejected) {
  state.count_triangle_tried();
  for (const point& q : arc_candidates(state, t)) {
    if (place_site(state, q, tolerance) == placement_outcome::inserted) return true;
    ++rejected;
  }
  return false;
}

std::optional<site> find_place(refine_state& state, const triangle& t, double tolerance,
                               std::size_t& rejected) {
  state.count_triangle_tried();
  for (const point& q : arc_candidates(state, t)) {
    if (state.strictly_inside(q)) {
      const auto s = state.site_at(q);
      if (s && state.is_farther(*s, tolerance) && state.encroached_by(*s).empty()) return s;
    }
    ++rejected;
  }
  return std::nullopt;
}

bool split_before_candidates(refine_state& state, const triangle& t, double tolerance) {
  state.count_triangle_tried();
  const std::vector<point> candidates = arc_candidates(state, t);
  return std::any_of(candidates.begin(), candidates.end(), [&](const point& q) {
    return !state.strictly_inside(q) && state.split_before(t, q, tolerance);
  });
}

}  // namespace asterism::internal
