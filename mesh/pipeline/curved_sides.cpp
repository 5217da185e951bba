// SPDX-License-Identifier: MIT
#include "asterism/mesh/pipeline/curved_sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "asterism/mesh/domain/nodes_on_curves.hpp"

namespace asterism {
using namespace internal;
namespace {

using ends = std::array<vertex_index, 2>;

error folded(const mesh& m, const second_order_report& report) {
  const bool is_certain = !report.folded.empty();
  const vertex_index t = is_certain ? report.folded.front() : report.undecided.front();
  const triangle& c = m.triangles[t];
  return {"second order: triangle " + std::to_string(t + 1) + " of the vertices " +
              std::to_string(c[0] + 1) + ", " + std::to_string(c[1] + 1) + " and " +
              std::to_string(c[2] + 1) +
              (is_certain ? " folds or collapses between its nodes"
                          : " is not proved to fold nowhere between its nodes"),
          error_code::invalid_mesh};
}

// Removes the nodes of sides of the triangles named. Returns the number of nodes removed.
std::size_t straighten(const mesh& m, const second_order_report& report,
                       std::vector<side_node>& nodes) {
  std::vector<ends> sides;
  for (const auto* const those : {&report.folded, &report.undecided})
    for (const vertex_index t : *those)
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index p = m.triangles[t][i], q = m.triangles[t][(i + 1) % 3];
        sides.push_back({std::min(p, q), std::max(p, q)});
      }
  std::sort(sides.begin(), sides.end());
  const std::size_t before = nodes.size();
  nodes.erase(
      std::remove_if(nodes.begin(), nodes.end(),
                     [&](const side_node& s) {
                       return std::binary_search(sides.begin(), sides.end(), ends{s.a, s.b});
                     }),
      nodes.end());
  return before - nodes.size();
}

}  // namespace

result<curved_sides> curve_sides(const mesh& m, const domain& shape) {
  curved_sides made;
  made.nodes = nodes_on_curves(m, shape);
  std::size_t straightened = 0;
  // Repeats until no triangle folds. Ends: each round but the last removes a node, of which there
  // are finitely many.
  while (true) {
    made.report = prove_second_order(m, made.nodes, &shape);
    if (made.report.proved() || m.triangles.empty()) break;
    const std::size_t gone = straighten(m, made.report, made.nodes);
    if (gone == 0) return folded(m, made.report);
    straightened += gone;
  }
  made.report.kept_straight = straightened;
  return made;
}

result<curved_sides> given_sides(const mesh& m, std::vector<side_node> nodes) {
  curved_sides made{std::move(nodes), {}};
  made.report = prove_second_order(m, made.nodes, nullptr);
  if (!made.report.proved() && !m.triangles.empty()) return folded(m, made.report);
  return made;
}

std::string note_of_straight_sides(const second_order_report& report) {
  if (report.kept_straight == 0) return "";
  return std::to_string(report.kept_straight) +
         (report.kept_straight == 1 ? " side on a curve is" : " sides on curves are") +
         " kept straight: a triangle would fold";
}

}  // namespace asterism
