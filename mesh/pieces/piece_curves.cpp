// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/piece_curves.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace asterism::internal {
namespace {

point blend(const point& a, const point& b, double t) {
  return {(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y};
}

// Returns the polar form of a cubic (de Casteljau), symmetric in its arguments.
point blossom(const std::array<point, 4>& control, double u, double v, double w) {
  std::array<point, 4> p = control;
  std::size_t left = 3;
  for (const double t : {u, v, w}) {
    for (std::size_t i = 0; i < left; ++i) p[i] = blend(p[i], p[i + 1], t);
    --left;
  }
  return p[0];
}

// Returns the part of a curve from one of its vertices to another.
domain_curve part_of(const domain& d, const domain_curve& whole, std::size_t first,
                     std::size_t last) {
  if (first == 0 && last + 1 == whole.vertices.size()) return whole;
  domain_curve part = whole;
  const auto begin = static_cast<std::ptrdiff_t>(first),
             end = static_cast<std::ptrdiff_t>(last + 1);
  part.vertices.assign(whole.vertices.begin() + begin, whole.vertices.begin() + end);
  part.parameters.clear();
  const double t0 = whole.parameters[first], t1 = whole.parameters[last];
  for (std::size_t i = first; i <= last; ++i)
    part.parameters.push_back((whole.parameters[i] - t0) / (t1 - t0));
  part.parameters.front() = 0;
  part.parameters.back() = 1;
  if (whole.kind == curve_kind::arc) return part;
  const std::array<point, 4> control = {d.vertices[whole.vertices.front()], whole.control[0],
                                        whole.control[1], d.vertices[whole.vertices.back()]};
  part.control = {blossom(control, t0, t0, t1), blossom(control, t0, t1, t1)};
  return part;
}

}  // namespace

std::vector<domain_curve> curves_of_piece(const domain& d, const domain_cut& cut,
                                          piece_index piece) {
  if (d.curves.empty()) return {};
  // Uncut edges of the piece, by their ends. A chord that a cut divides is not among them: its
  // parts have other ends.
  std::map<std::pair<vertex_index, vertex_index>, bool> is_here;
  for (const cut_edge& e : cut.edges)
    if (!e.is_cut() && !e.is_seam() && (e.left == piece || e.right == piece))
      is_here[std::minmax(e.a, e.b)] = true;
  std::vector<domain_curve> parts;
  for (const domain_curve& c : d.curves)
    for (std::size_t i = 0; i + 1 < c.vertices.size();) {
      std::size_t end = i;
      while (end + 1 < c.vertices.size() &&
             is_here.count(std::minmax(c.vertices[end], c.vertices[end + 1])) != 0)
        ++end;
      if (end > i) parts.push_back(part_of(d, c, i, end));
      i = std::max(end, i + 1);
    }
  return parts;
}

}  // namespace asterism::internal
