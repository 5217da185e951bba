// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/bamg_bends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

constexpr std::array<std::string_view, 5> curve_sections = {
    "AngleOfCornerBound", "MaximalAngleOfCorner", "TangentAtEdges", "Tangents", "hVertices"};

// The ends of the edges at a vertex, as far as there are two.
struct ends_at_vertex {
  std::array<vertex_index, 2> others{};
  std::size_t edges = 0;
};

std::vector<ends_at_vertex> ends_at_vertices(const mesh& m) {
  std::vector<ends_at_vertex> at(m.sites.size());
  for (const boundary_edge& e : m.boundary)
    for (const auto& [v, other] : {std::pair{e.a, e.b}, {e.b, e.a}}) {
      if (at[v].edges < 2) at[v].others[at[v].edges] = other;
      ++at[v].edges;
    }
  return at;
}

}  // namespace

bool is_about_bamg_curves(std::string_view keyword) {
  return std::find(curve_sections.begin(), curve_sections.end(), keyword) != curve_sections.end();
}

std::optional<std::string> note_of_bamg_bends(const mesh& edges,
                                              const std::vector<vertex_index>& corners) {
  std::vector<ends_at_vertex> at = ends_at_vertices(edges);
  for (const vertex_index v : corners)
    if (v < at.size()) at[v].edges = 0;
  std::size_t count = 0, first = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto& [others, number] = at[v];
    if (number != 2 ||
        filtered_kernel().orientation(edges.sites[others[0]].position, edges.sites[v].position,
                                      edges.sites[others[1]].position) == sign::zero)
      continue;
    if (count++ == 0) first = v;
  }
  if (count == 0) return std::nullopt;
  const point& p = edges.sites[first].position;
  return fmt::format(
      "edges are straight here; BAMG has curves through vertices that are no corners and at which "
      "edges turn by less than its bound: of {} that are no corners the first is vertex {} at "
      "({:g}, {:g})",
      count, first + 1, p.x, p.y);
}

}  // namespace asterism::internal
