// SPDX-License-Identifier: MIT
#include "asterism/mesh/refine/site_insertion.hpp"

#include <algorithm>

namespace asterism::internal {
namespace {

// True if the triangle's two vertices other than the corner lie in the corner's sector, ends
// included.
bool lies_in_corner(const refine_state& state, const triangle& t, const domain_corner& c) {
  const sector& s = state.stars()[c.vertex].sectors[c.sector];
  const site_oracle oracle = state.oracle();
  return std::all_of(t.begin(), t.end(), [&](vertex_index u) {
    return u == c.vertex || locate(oracle, c.vertex, s, u).kind != placement_kind::outside;
  });
}

}  // namespace

placement_outcome place_site(refine_state& state, const point& q, double tolerance) {
  if (!state.strictly_inside(q))
    return state.split_at_place(q, tolerance) ? placement_outcome::inserted
                                              : placement_outcome::outside;
  const auto s = state.site_at(q);
  if (!s) return placement_outcome::outside;
  if (!state.is_farther(*s, tolerance)) return placement_outcome::too_near;
  const std::vector<std::size_t> encroached = state.encroached_by(*s);
  if (encroached.empty()) {
    state.add_interior(*s);
    return placement_outcome::inserted;
  }
  bool any = false;
  for (const std::size_t subsegment : encroached) any |= state.split(subsegment, tolerance);
  return any ? placement_outcome::inserted : placement_outcome::subsegment_too_short;
}

bool shorten_tight_corner(refine_state& state, const triangle& bad, const angle_requirement& angle,
                          double tolerance) {
  std::vector<domain_corner> tight;
  for (const vertex_index v : bad)
    for (const domain_corner& c : state.segments().corners_at(v))
      if (c.angle < 2 * angle.degrees()) tight.push_back(c);
  std::sort(tight.begin(), tight.end(), [](const domain_corner& a, const domain_corner& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.sector < b.sector;
  });
  for (const domain_corner& c : tight) {
    if (!lies_in_corner(state, bad, c)) continue;
    auto [longer, shorter] = state.segments().subsegments_at(c);
    if (state.segments().subsegment_length(longer, c.vertex) <
        state.segments().subsegment_length(shorter, c.vertex))
      std::swap(longer, shorter);
    if (state.split(longer, tolerance) || state.split(shorter, tolerance)) return true;
  }
  return false;
}

}  // namespace asterism::internal
