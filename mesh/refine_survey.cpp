// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine_survey.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace asterism {
namespace {

// The order in which bad triangles are tried decides how many sites it takes; ties by position in
// the mesh, so that the order is the same every time.
void sort_worst_first(std::vector<bad_triangle>& bad) {
  std::sort(bad.begin(), bad.end(), [](const bad_triangle& a, const bad_triangle& b) {
    return std::tie(a.why, a.rank, a.where) < std::tie(b.why, b.rank, b.where);
  });
}

void add_disagreeing(const refine_state& state, survey& s) {
  std::vector<triangle> where = s.consistency.disagreeing;
  for (const defect& d : s.consistency.defects) {
    if (d.kind == defect_kind::wide_gap) where.push_back(d.where);
    if (d.kind != defect_kind::unsettled) continue;
    for (const triangle& t : s.consistency.agreeing)
      if (std::find(t.begin(), t.end(), d.owner) != t.end()) where.push_back(t);
  }
  std::sort(where.begin(), where.end());
  where.erase(std::unique(where.begin(), where.end()), where.end());
  for (const triangle& t : where)
    s.bad.push_back({badness::disagreeing, smallest_angle(sites_of(state, t)), t});
  s.disagreeing = where.size();
}

// Both lists of triangles are in lexicographic order.
void measure_shapes(const refine_state& state, const angle_requirement& angle, bool limit_size,
                    const survey& previous, survey& s) {
  const auto& known = previous.consistency.agreeing;
  auto at = known.begin();
  for (const triangle& t : s.consistency.agreeing) {
    at = std::lower_bound(at, known.end(), t);
    if (at != known.end() && *at == t) {
      s.shapes.push_back(previous.shapes[static_cast<std::size_t>(at - known.begin())]);
      continue;
    }
    const triangle_sites sites = sites_of(state, t);
    triangle_shape shape{angle.is_low(sites), 0, 0};
    if (shape.is_low) shape.smallest_angle = smallest_angle(sites);
    if (limit_size) shape.circumradius = metric_circumradius(sites);
    s.shapes.push_back(shape);
  }
}

bool touches(const triangle& t, const std::vector<exempt_corner>& corners) {
  return std::any_of(corners.begin(), corners.end(), [&](const exempt_corner& c) {
    return std::find(t.begin(), t.end(), c.vertex) != t.end();
  });
}

// The triangle's corners that lie at an exempt corner of the domain and fill it from one piece to
// the other. A part of a divided corner could be wider.
std::array<bool, 3> unavoidable(const refine_state& state, const triangle& t,
                                const std::vector<exempt_corner>& corners) {
  std::array<bool, 3> at{};
  for (std::size_t i = 0; i < 3; ++i)
    at[i] = std::any_of(corners.begin(), corners.end(),
                        [&](const exempt_corner& c) { return c.vertex == t[i]; }) &&
            state.edges().is_piece(t[i], t[(i + 1) % 3]) &&
            state.edges().is_piece(t[(i + 2) % 3], t[i]);
  return at;
}

void judge(const refine_state& state, const angle_requirement& angle, const triangle& t,
           const triangle_shape& shape, const std::vector<exempt_corner>& exempt, survey& s) {
  if (shape.is_low && touches(t, exempt)) {
    s.exempt.push_back(t);
    if (angle.is_low(sites_of(state, t), unavoidable(state, t, exempt)))
      s.improvable.push_back({badness::low_angle, shape.smallest_angle, t});
  } else if (shape.is_low) {
    s.bad.push_back({badness::low_angle, shape.smallest_angle, t});
    ++s.low_angle;
    return;
  }
  if (!(shape.circumradius > largest_circumradius)) return;
  s.bad.push_back({badness::too_large, -shape.circumradius, t});
  ++s.too_large;
}

}  // namespace

triangle_sites sites_of(const refine_state& state, const triangle& t) {
  return {state.sites()[t[0]], state.sites()[t[1]], state.sites()[t[2]]};
}

std::vector<exempt_corner> exempt_corners(const refine_state& state,
                                          const angle_requirement& angle) {
  std::map<index, double> smallest;
  for (const domain_corner& c : state.corners()) {
    if (!(c.angle < angle.degrees())) continue;
    const auto [at, added] = smallest.try_emplace(c.vertex, c.angle);
    if (!added) at->second = std::min(at->second, c.angle);
  }
  std::vector<exempt_corner> corners;
  corners.reserve(smallest.size());
  for (const auto& [vertex, degrees] : smallest) corners.push_back({vertex, degrees});
  return corners;
}

survey take_survey(const refine_state& state, const angle_requirement& angle, bool limit_size,
                   const survey& previous) {
  survey s;
  s.consistency = check_consistency(state.oracle(), state.stars());
  add_disagreeing(state, s);
  measure_shapes(state, angle, limit_size, previous, s);
  const auto exempt = exempt_corners(state, angle);
  for (std::size_t i = 0; i < s.shapes.size(); ++i)
    judge(state, angle, s.consistency.agreeing[i], s.shapes[i], exempt, s);
  sort_worst_first(s.bad);
  sort_worst_first(s.improvable);
  return s;
}

}  // namespace asterism
