// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/bamg_bends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "asterism/core/elementary.hpp"
#include "asterism/kernels/filtered_kernel.hpp"

namespace asterism::internal {
namespace {

constexpr std::array<std::string_view, 5> curve_sections = {
    "AngleOfCornerBound", "MaximalAngleOfCorner", "TangentAtEdges", "Tangents", "hVertices"};

// The first two edges at a vertex, by their other ends.
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

// True if the edges a-b and b-c turn at b, and by less than the angle of this cosine.
bool bends(const point& a, const point& b, const point& c, double cosine) {
  if (filtered_kernel().orientation(a, b, c) == sign::zero) return false;
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  const double lengths = std::sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
  return ux * vx + uy * vy > cosine * lengths;
}

}  // namespace

bool is_about_bamg_curves(std::string_view keyword) {
  return std::find(curve_sections.begin(), curve_sections.end(), keyword) != curve_sections.end();
}

std::optional<std::string> note_of_bamg_bends(const mesh& edges,
                                              const std::vector<vertex_index>& corners,
                                              double bound) {
  constexpr double degree = 0.017453292519943295;
  const double cosine = elementary::cos(bound * degree);
  std::vector<ends_at_vertex> at = ends_at_vertices(edges);
  for (const vertex_index v : corners)
    if (v < at.size()) at[v].edges = 0;
  const auto place = [&](std::size_t v) { return edges.sites[v].position; };
  std::size_t count = 0, first = 0;
  for (std::size_t v = 0; v < at.size(); ++v) {
    const auto& [others, number] = at[v];
    if (number != 2 || !bends(place(others[0]), place(v), place(others[1]), cosine)) continue;
    if (count++ == 0) first = v;
  }
  if (count == 0) return std::nullopt;
  return fmt::format(
      "edges are straight here; BAMG has curves through {} of their vertices, where they turn by "
      "less than {:g} degrees and no corner is listed, the first: vertex {} at ({:g}, {:g})",
      count, bound, first + 1, place(first).x, place(first).y);
}

}  // namespace asterism::internal
