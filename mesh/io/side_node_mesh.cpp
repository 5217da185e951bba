// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/side_node_mesh.hpp"

#include <algorithm>
#include <cstddef>

namespace asterism::internal {
namespace {

// A side, and the place for the number of its node.
struct used_side {
  std::array<vertex_index, 2> ends;
  vertex_index* number;
};

std::vector<used_side> sides_of(side_node_mesh& made) {
  std::vector<used_side> sides;
  const auto add = [&sides](vertex_index p, vertex_index q, vertex_index& number) {
    sides.push_back({{std::min(p, q), std::max(p, q)}, &number});
  };
  std::size_t cell = 0;
  for (const auto* const triangles : {&made.content.triangles, &made.content.disagreeing})
    for (const triangle& t : *triangles) {
      for (std::size_t i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3], made.of_triangles[cell][i]);
      ++cell;
    }
  for (std::size_t e = 0; e < made.of_edges.size(); ++e)
    add(made.content.boundary[e].a, made.content.boundary[e].b, made.of_edges[e]);
  std::sort(sides.begin(), sides.end(),
            [](const used_side& p, const used_side& q) { return p.ends < q.ends; });
  return sides;
}

double mean(double p, double q) { return 0.5 * p + 0.5 * q; }

site node_between(const site& p, const site& q) {
  return {middle_of_side(p.position, q.position),
          {mean(p.metric.m11, q.metric.m11), mean(p.metric.m12, q.metric.m12),
           mean(p.metric.m22, q.metric.m22)}};
}

void add_values(solution& fields, const std::array<vertex_index, 2>& ends) {
  ++fields.vertices;
  for (solution_field& field : fields.fields) {
    const std::size_t c = components_of(field.kind);
    for (std::size_t i = 0; i < c; ++i)
      field.values.push_back(mean(field.values[ends[0] * c + i], field.values[ends[1] * c + i]));
  }
}

}  // namespace

side_node_mesh with_side_nodes(const mesh& m, const std::vector<side_node>& curved,
                               const solution* fields) {
  side_node_mesh made{m, {}, {}, {}};
  if (fields != nullptr) made.fields = *fields;
  made.of_triangles.resize(m.triangles.size() + m.disagreeing.size());
  made.of_edges.resize(m.boundary.size());
  auto next = curved.begin();
  const std::array<vertex_index, 2>* last = nullptr;
  const std::vector<used_side> sides = sides_of(made);
  for (const used_side& side : sides) {
    if (last == nullptr || *last != side.ends) {
      site node = node_between(m.sites[side.ends[0]], m.sites[side.ends[1]]);
      while (next != curved.end() && std::array{next->a, next->b} < side.ends) ++next;
      if (next != curved.end() && std::array{next->a, next->b} == side.ends)
        node.position = next->at;
      made.content.sites.push_back(node);
      add_values(made.fields, side.ends);
      last = &side.ends;
    }
    *side.number = static_cast<vertex_index>(made.content.sites.size() - 1);
  }
  return made;
}

}  // namespace asterism::internal
