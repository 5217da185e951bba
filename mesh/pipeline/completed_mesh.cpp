// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/completed_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "asterism/core/elementary.hpp"
#include "asterism/mesh/delivery/assign_regions.hpp"
#include "asterism/mesh/search/triangle_sides.hpp"

namespace asterism::internal {
namespace {

using ends = std::array<vertex_index, 2>;

// Follows segments of the domain along the sides of the mesh's triangles.
class segment_walk {
 public:
  segment_walk(const domain& d, const mesh& m) : d_(d), m_(m), sides_(m) {}

  // Returns the vertices along a segment, its ends included; none where no sides lead along it.
  std::optional<std::vector<vertex_index>> along(const segment& s) const {
    std::vector<vertex_index> found{s.a};
    while (found.back() != s.b && found.size() <= m_.sites.size()) {
      const auto next = step(s, found.back());
      if (!next) return std::nullopt;
      found.push_back(*next);
    }
    if (found.back() != s.b) return std::nullopt;
    return found;
  }

 private:
  // Returns the neighbour that is nearest to the direction of the segment's end, and on the
  // boundary if the segment is. Leaves out vertices of the domain, which can only be the segment's
  // end.
  std::optional<vertex_index> step(const segment& s, vertex_index at) const {
    std::optional<vertex_index> best;
    double most = 0;
    sides_.each_from(at, [&](vertex_index next) {
      if (next != s.b && next < d_.vertices.size()) return;
      if ((sides_.find(next, at) != nullptr) != s.internal) return;
      const double forward = cosine(at, next, s.b);
      if (!(forward > most)) return;
      most = forward;
      best = next;
    });
    return best;
  }

  double cosine(vertex_index at, vertex_index next, vertex_index end) const {
    const point &o = m_.sites[at].position, &p = m_.sites[next].position,
                &q = m_.sites[end].position;
    const double x = p.x - o.x, y = p.y - o.y, u = q.x - o.x, v = q.y - o.y;
    return (x * u + y * v) / (elementary::hypot(x, y) * elementary::hypot(u, v));
  }

  const domain& d_;
  const mesh& m_;
  triangle_sides sides_;
};

result<std::vector<boundary_edge>> subsegments_of(const domain& d, const mesh& m) {
  const segment_walk walk(d, m);
  std::vector<boundary_edge> made;
  for (vertex_index s = 0; s < d.segments.size(); ++s) {
    const segment& whole = d.segments[s];
    const auto along = walk.along(whole);
    if (!along)
      return error{fmt::format("no edges lead along segment {} from vertex {} to vertex {}", s + 1,
                               whole.a + 1, whole.b + 1)};
    for (std::size_t i = 0; i + 1 < along->size(); ++i)
      made.push_back({(*along)[i], (*along)[i + 1], s, whole.marker, whole.internal});
  }
  return made;
}

// Returns a sentence where the edges that the file lists are not those of the domain.
std::optional<error> contradiction_of(const std::vector<boundary_edge>& listed,
                                      const std::vector<boundary_edge>& made) {
  std::map<ends, int> marker_of;
  for (const boundary_edge& e : made)
    marker_of[{std::min(e.a, e.b), std::max(e.a, e.b)}] = e.marker;
  std::map<int, int> translated;
  for (const boundary_edge& e : listed) {
    const auto found = marker_of.find({std::min(e.a, e.b), std::max(e.a, e.b)});
    if (found == marker_of.end())
      return error{
          fmt::format("the edge from vertex {} to vertex {} is on no segment", e.a + 1, e.b + 1)};
    const auto [known, is_new] = translated.emplace(e.marker, found->second);
    if (!is_new && known->second != found->second)
      return error{fmt::format("edges of its marker {} are on segments of the markers {} and {}",
                               e.marker, known->second, found->second)};
  }
  return std::nullopt;
}

}  // namespace

result<mesh> completed_by(const domain& d, mesh m) {
  bool is_kept = d.vertices.size() <= m.sites.size();
  for (std::size_t v = 0; is_kept && v < d.vertices.size(); ++v)
    is_kept = m.sites[v].position == d.vertices[v];
  if (!is_kept) return error{"its first vertices are not those of the domain"};
  m.given = static_cast<vertex_index>(d.vertices.size());
  auto made = subsegments_of(d, m);
  if (!made) return made.failure();
  if (auto failed = contradiction_of(m.boundary, made.value())) return *failed;
  m.boundary = std::move(made).value();
  m.references.clear();
  if (m.regions.empty()) assign_regions(m, d);
  return m;
}

}  // namespace asterism::internal
