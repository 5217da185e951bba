// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/periodic_outline.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/periodic_partners.hpp"
#include "asterism/mesh/pipeline/periodic_mesh.hpp"

namespace asterism::internal {
namespace {

// Adds the vertices that the outline keeps on the first sides of the pairs, or on both sides, and
// their partners, to the required ones. Returns whether any vertex was kept without its partner.
bool require_partners(const mesh& m, const mesh_outline& outline,
                      const std::vector<periodic_pair>& pairs, bool first_alone,
                      mesh_marks& marks) {
  std::vector<point> kept = outline.shape.vertices;
  std::sort(kept.begin(), kept.end(), lexicographically_less);
  const auto is_kept = [&](vertex_index v) {
    return std::binary_search(kept.begin(), kept.end(), m.sites[v].position,
                              lexicographically_less);
  };
  bool any = false;
  for (const periodic_pair& one : pairs) {
    const auto partners = periodic_partners(m, one.first, one.second);
    if (!partners) continue;
    for (const auto& [a, b] : partners.value()) {
      const bool is_first = is_kept(a), is_second = is_kept(b);
      if (is_first || (is_second && !first_alone))
        marks.required_vertices.insert(marks.required_vertices.end(), {a, b});
      any = any || is_first != is_second;
    }
  }
  return any;
}

}  // namespace

result<periodic_outline> outline_with_partners(const mesh& m, mesh_marks marks, outline_options how,
                                               const std::vector<periodic_pair>& pairs) {
  constexpr int most_times = 8;
  std::set<int> markers;
  for (const periodic_pair& one : pairs) markers.insert({one.first, one.second});
  how.polygons.assign(markers.begin(), markers.end());
  for (int times = 0; times < most_times; ++times) {
    auto found = outline_of_mesh(m, marks, how);
    if (!found) return found.failure();
    if (!check_periodic(found.value().shape, pairs))
      return periodic_outline{std::move(found).value(), {}};
    if (!require_partners(m, found.value(), pairs, times == 0, marks)) break;
  }
  for (const boundary_edge& e : m.boundary)
    if (markers.contains(e.marker)) marks.required_edges.push_back({e.a, e.b});
  auto whole = outline_of_mesh(m, marks, how);
  if (!whole) return whole.failure();
  return periodic_outline{std::move(whole).value(), {markers.begin(), markers.end()}};
}

}  // namespace asterism::internal
