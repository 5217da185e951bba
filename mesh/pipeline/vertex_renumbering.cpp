// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/vertex_renumbering.hpp"

#include <cstddef>
#include <cstdint>
#include <numeric>

#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/stars/canonical_triangle.hpp"
#include "asterism/mesh/stars/consistency.hpp"

namespace asterism::internal {
namespace {

// Returns the vertices that are on no segment, ascending.
std::vector<vertex_index> isolated_of(const domain& d) {
  std::vector<char> is_on_segment(d.vertices.size(), 0);
  for (const segment& s : d.segments) is_on_segment[s.a] = is_on_segment[s.b] = 1;
  std::vector<vertex_index> isolated;
  for (std::size_t v = 0; v < is_on_segment.size(); ++v)
    if (is_on_segment[v] == 0) isolated.push_back(static_cast<vertex_index>(v));
  return isolated;
}

// True if the vertices are nearly sorted along the space-filling curve: at most one step in eight
// goes back; in a random order every other step does.
bool are_along_curve(const domain& d, const std::vector<vertex_index>& which,
                     const bounding_box& box) {
  constexpr std::size_t one_in = 8;
  std::size_t back = 0;
  std::uint64_t last = 0;
  for (const vertex_index v : which) {
    const std::uint64_t place = place_on_curve(d.vertices[v], box);
    back += place < last ? 1 : 0;
    last = place;
  }
  return one_in * back <= which.size();
}

}  // namespace

vertex_renumbering::vertex_renumbering(const domain& d) : given_(d) {
  constexpr std::size_t few = 5000;  // fewer are near each other in memory anyway
  if (d.vertices.size() < few) return;
  std::vector<vertex_index> isolated = isolated_of(d);
  const bounding_box box = d.box();
  if (isolated.size() < few || are_along_curve(d, isolated, box)) return;
  isolated_ = std::move(isolated);
  renumber(box);
}

void vertex_renumbering::renumber(const bounding_box& box) {
  along_curve_ = given_;
  sorted_ = isolated_;
  sort_along_curve(sorted_, given_.vertices, box);
  along_curve_.origin.vertex_lines.clear();  // of the numbers given; nothing asks for them here
  for (std::size_t i = 0; i < isolated_.size(); ++i)
    along_curve_.vertices[isolated_[i]] = given_.vertices[sorted_[i]];
}

// Renumbers the corners of triangles. Keeps the order of the triangles, which is along the curve.
void vertex_renumbering::restore(mesh_outcome& outcome) const {
  if (isolated_.empty()) return;
  mesh& m = outcome.result;
  std::vector<vertex_index> to(m.sites.size());
  std::iota(to.begin(), to.end(), vertex_index{0});
  std::vector<site> along_curve;
  along_curve.reserve(isolated_.size());
  for (const vertex_index v : isolated_) along_curve.push_back(m.sites[v]);
  for (std::size_t i = 0; i < isolated_.size(); ++i) {
    to[isolated_[i]] = sorted_[i];
    m.sites[sorted_[i]] = along_curve[i];
  }
  for (auto* triangles : {&m.triangles, &m.disagreeing, &outcome.exempt_triangles})
    for (triangle& t : *triangles) t = canonical({to[t[0]], to[t[1]], to[t[2]]});
  outcome.audited.reset();  // it names vertices by their numbers
}

}  // namespace asterism::internal
