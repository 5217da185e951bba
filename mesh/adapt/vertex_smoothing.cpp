// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/vertex_smoothing.hpp"

#include <algorithm>
#include <utility>

#include "asterism/mesh/support/parallel.hpp"
#include "asterism/mesh/support/sort_by_counting.hpp"

namespace asterism::internal::adapting {
namespace {

// Degrees above the angle bound from which an angle counts as no defect.
constexpr double settled_degrees_above = 1;
constexpr std::size_t at_once = 1024;  // nodes or faces, for a thread

bool is_movable(const node& n) { return n.kind == node_kind::free || n.kind == node_kind::sliding; }

}  // namespace

struct vertex_smoothing::side_products {
  metric_tensor uu, uw, ww;  // the products of the two coordinates are doubled
  double twice;              // area

  // Returns the greatest cotangent of the face's angles in the metric m, times twice its area in m.
  double greatest(const metric_tensor& m) const {
    const auto measured = [&m](const metric_tensor& p) {
      return m.m11 * p.m11 + m.m12 * p.m12 + m.m22 * p.m22;
    };
    const double u = measured(uu), w = measured(ww), inner = measured(uw);
    return std::max({inner, u - inner, w - inner});
  }
};

vertex_smoothing::vertex_smoothing(editable_mesh& m, double angle_bound, double unit,
                                   wanted_at wanted)
    : whole_(m, angle_bound, unit, std::move(wanted)),
      angle_bound_(angle_bound),
      cotangent_(cotangent_of(angle_bound + settled_degrees_above)) {}

// True if angles of less than half of the bound are around many nodes: then the metric is not
// resolved. In two fronts that cross 22 to 51 % of the nodes have such angles, in other functions
// at most 14 % (docs/design/adaptation.md).
bool vertex_smoothing::is_in_vain() const {
  constexpr std::size_t part = 6;
  const double most = cotangent_of(angle_bound_ / 2);
  const editable_mesh& m = whole_.m;
  m.note_looked_at(m.faces().size());
  const auto append = [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!m.faces()[t].exists()) continue;
      const side_products sides = sides_of(static_cast<vertex_index>(t));
      for (const vertex_index u : m.faces()[t].v)
        if (sides.greatest(whole_.wanted[u].metric) > most * whole_.wanted[u].root * sides.twice)
          found.push_back(u);
    }
  };
  constexpr std::size_t chunk = 4096;
  std::vector<char> is_far_below(m.nodes().size(), 0);
  for (const vertex_index u : collect_chunks<vertex_index>(m.faces().size(), chunk, append))
    is_far_below[u] = 1;
  const auto far_below =
      static_cast<std::size_t>(std::count(is_far_below.begin(), is_far_below.end(), char{1}));
  return part * far_below > m.count();
}

void vertex_smoothing::run(const cancellation& stop) {
  constexpr int most_sweeps = 3;
  find_defect_free();
  divide();
  const std::size_t parts = first_.size() - 2;
  std::vector<char> has_moved(parts + 1, 1);
  const auto any = [&has_moved] {
    return std::find(has_moved.begin(), has_moved.end(), char{1}) != has_moved.end();
  };
  const auto settle = [&](std::size_t part) { has_moved[part] = settle_part(part) ? 1 : 0; };
  for (int sweep = 0; any() && sweep < most_sweeps && !stop.is_requested(); ++sweep) {
    parallel_for(parts, settle);
    settle(parts);
    whole_.m.charge_work(stop);
  }
}

// Marks the nodes without a defect. These are most nodes, and take most of the time: several
// threads work, as no node moves meanwhile.
void vertex_smoothing::find_defect_free() {
  const editable_mesh& m = whole_.m;
  whole_.present.forget_all();
  whole_.present.find_all();
  parallel_chunks(m.nodes().size(), at_once, [&](std::size_t, std::size_t begin, std::size_t end) {
    node_settling at(whole_, cotangent_);
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<vertex_index>(i);
      if (i + sites_ahead < end) m.prefetch_face_at(i + sites_ahead);
      if (is_movable(m.at(v))) whole_.is_defect_free[v] = at.has_defect(v) ? 0 : 1;
    }
  });
}

// Lists the nodes that may be moved. A mesh too small for two parts has all among the last ones, in
// the order of their numbers.
void vertex_smoothing::divide() {
  // With this number 11 to 21 % of 100,000 nodes are near other parts.
  constexpr std::size_t faces_in_part = 16384;
  const editable_mesh& m = whole_.m;
  const curve_parts parts(m.nodes(), m.faces(), m.shape().box(), m.faces().size() / faces_in_part);
  const std::size_t inner = parts.count() > 1 ? parts.count() : 0;
  const std::vector<char> is_near = nodes_near_other_parts(parts);
  const auto part_of = [&](std::size_t i) -> std::size_t {
    const node& n = m.nodes()[i];
    if (!is_movable(n)) return inner + 1;
    return inner == 0 || is_near[i] != 0 ? inner : parts.of(n.face);
  };
  nodes_.resize(m.nodes().size());
  first_ = sort_by_counting(
      m.nodes().size(), inner + 2, part_of,
      [this](std::size_t at, std::size_t v) { nodes_[at] = static_cast<vertex_index>(v); });
  first_.pop_back();
}

// Marks the nodes with faces in several parts, and then the nodes of faces with such a node. The
// move of any other node reads and changes faces of one part alone, and their nodes. Of these
// several parts may have those across from the node, which stay: they count as nodes with a defect
// from the start, so that no thread changes their flags.
std::vector<char> vertex_smoothing::nodes_near_other_parts(const curve_parts& parts) {
  const editable_mesh& m = whole_.m;
  std::vector<char> is_near(m.nodes().size(), 0);
  if (parts.count() == 1) return is_near;
  const auto mark = [&](const auto& is_concerned) {
    const auto append = [&](std::size_t begin, std::size_t end, std::vector<vertex_index>& found) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto t = static_cast<vertex_index>(i);
        if (i + triangles_ahead < end) m.prefetch_corners(i + triangles_ahead);
        for (const vertex_index v : m.faces()[t].v)
          if (m.faces()[t].exists() && is_concerned(t, v)) found.push_back(v);
      }
    };
    for (const vertex_index v : collect_chunks<vertex_index>(m.faces().size(), at_once, append))
      is_near[v] = 1;
  };
  mark([&](vertex_index t, vertex_index v) { return parts.of(t) != parts.of(m.at(v).face); });
  for (std::size_t v = 0; v < is_near.size(); ++v)
    if (is_near[v] != 0) whole_.is_defect_free[v] = 0;
  mark([&](vertex_index t, vertex_index) {
    const auto& corners = m.faces()[t].v;
    return std::any_of(corners.begin(), corners.end(),
                       [&](vertex_index v) { return is_near[v] != 0; });
  });
  return is_near;
}

// Moves the nodes of a part that are awake, in their order. Returns whether any was moved.
bool vertex_smoothing::settle_part(std::size_t part) {
  node_settling at(whole_, cotangent_);
  bool any = false;
  for (std::size_t i = first_[part]; i < first_[part + 1]; ++i) {
    const vertex_index v = nodes_[i];
    if (i + sites_ahead < first_[part + 1]) whole_.m.prefetch_face_at(nodes_[i + sites_ahead]);
    if (std::exchange(whole_.is_awake[v], char{0}) == 0) continue;
    if (whole_.is_defect_free[v] == 0 && at.settle(v)) any = true;
  }
  return any;
}

vertex_smoothing::side_products vertex_smoothing::sides_of(vertex_index t) const {
  const editable_mesh& m = whole_.m;
  const face& f = m.faces()[t];
  const point &a = m.at(f.v[0]).position, &b = m.at(f.v[1]).position, &c = m.at(f.v[2]).position;
  const double ux = b.x - a.x, uy = b.y - a.y, wx = c.x - a.x, wy = c.y - a.y;
  const double across = ux * wy, back = uy * wx;
  return {{ux * ux, 2 * ux * uy, uy * uy},
          {ux * wx, across + back, uy * wy},
          {wx * wx, 2 * wx * wy, wy * wy},
          across - back};
}

}  // namespace asterism::internal::adapting
