// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/mesh_gradation.hpp"

#include <vector>

#include "asterism/mesh/adapt/nodal_gradation.hpp"

namespace asterism::internal::adapting {

void grade_mesh(working_mesh& m, double distortion, double unit, const cancellation& stop) {
  std::vector<point> places;
  std::vector<metric_tensor> tensors;
  for (const node& n : m.nodes()) {
    places.push_back(n.position);
    tensors.push_back(n.metric);
  }
  std::vector<graph_edge> edges;
  for (const face& f : m.faces()) {
    if (!f.exists()) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const vertex_index a = f.v[after(i)], b = f.v[before(i)];
      if (f.next[i] == none || a < b) edges.push_back({a, b});
    }
  }
  gradation_limit limit;
  limit.distortion = distortion;
  limit.unit = unit;
  limit.shortest = 0.5;
  grade(places, edges, limit, tensors, stop);
  for (vertex_index v = 0; v < tensors.size(); ++v)
    if (m.at(v).kind != node_kind::gone && !identical(tensors[v], m.at(v).metric))
      m.set_metric(v, tensors[v]);
}

nodal_field field_of(working_mesh& m) {
  std::vector<vertex_index> renumbered;
  nodal_field made(m.triangulation(renumbered));
  // Cells are the faces there are, in their order: every face turns left.
  vertex_index cell = 0;
  for (const face& f : m.faces()) {
    if (!f.exists()) continue;
    for (const vertex_index v : f.v) m.at(v).hint = cell;
    ++cell;
  }
  return made;
}

}  // namespace asterism::internal::adapting
