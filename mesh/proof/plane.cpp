// SPDX-License-Identifier: MIT
#include "asterism/mesh/proof/plane.hpp"

#include <algorithm>

namespace asterism::internal::proof_detail {
namespace {

struct numbered_edge {
  std::uint64_t ends = 0;  // the lesser vertex, and the other
  std::uint32_t number = 0;
  bool is_backward = false;

  friend bool operator<(const numbered_edge& e, const numbered_edge& f) {
    return e.ends < f.ends || (e.ends == f.ends && e.number < f.number);
  }
};

std::uint64_t ends_of(vertex_index a, vertex_index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

std::vector<numbered_edge> sorted_edges(const plane& all) {
  std::vector<numbered_edge> edges;
  edges.reserve(3 * all.triangles.size());
  for (std::uint32_t e = 0; e < 3 * all.triangles.size(); ++e) {
    const vertex_index a = all.corner(e), b = all.corner(plane::next(e));
    edges.push_back({ends_of(a, b), e, b < a});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void join(plane& all) {
  const std::vector<numbered_edge> edges = sorted_edges(all);
  std::vector<std::uint64_t> segments;
  for (const boundary_edge& e : all.subject.boundary) segments.push_back(ends_of(e.a, e.b));
  std::sort(segments.begin(), segments.end());
  all.across.assign(edges.size(), plane::none);
  all.is_segment.assign(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].ends == edges[i].ends) ++end;
    if (end - i == 2 && edges[i].is_backward != edges[i + 1].is_backward) {
      all.across[edges[i].number] = edges[i + 1].number;
      all.across[edges[i + 1].number] = edges[i].number;
    }
    if (std::binary_search(segments.begin(), segments.end(), edges[i].ends))
      for (std::size_t k = i; k < end; ++k) all.is_segment[edges[k].number] = 1;
    i = end;
  }
}

void gather(plane& all) {
  all.at_start.assign(all.subject.sites.size() + all.corners.size() + 1, 0);
  for (const triangle& t : all.triangles)
    for (const vertex_index v : t) ++all.at_start[v + 1];
  for (std::size_t v = 0; v + 1 < all.at_start.size(); ++v) all.at_start[v + 1] += all.at_start[v];
  std::vector<std::uint32_t> next(all.at_start.begin(), all.at_start.end() - 1);
  all.at.resize(3 * all.triangles.size());
  for (std::uint32_t t = 0; t < all.triangles.size(); ++t)
    for (const vertex_index v : all.triangles[t]) all.at[next[v]++] = t;
}

}  // namespace

plane make_plane(const mesh& subject, const std::array<point, 4>& corners,
                 const std::vector<triangle>& outside) {
  plane all{subject, corners, subject.triangles, {}, {}, {}, {}};
  all.triangles.insert(all.triangles.end(), outside.begin(), outside.end());
  join(all);
  gather(all);
  return all;
}

}  // namespace asterism::internal::proof_detail
