// SPDX-License-Identifier: MIT
#include "asterism/mesh/adapt/mesh_gradation.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/search/triangle_locator.hpp"
#include "asterism/mesh/support/number_present.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal::adapting {
namespace {

// Returns each edge of the mesh once.
std::vector<graph_edge> edges_of(const editable_mesh& m) {
  constexpr std::size_t faces_at_once = 4096;  // for a thread
  const auto append = [&m](std::size_t begin, std::size_t end, std::vector<graph_edge>& edges) {
    for (std::size_t t = begin; t < end; ++t) {
      const face& f = m.faces()[t];
      if (!f.exists()) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const vertex_index a = f.v[after(i)], b = f.v[before(i)];
        if (f.next[i] == none || a < b) edges.push_back({a, b});
      }
    }
  };
  return collect_chunks<graph_edge>(m.faces().size(), faces_at_once, append);
}

}  // namespace

void grade_mesh(editable_mesh& m, double distortion, double unit, const cancellation& stop) {
  std::vector<point> places;
  std::vector<metric_tensor> tensors;
  resize_in_threads(places, m.nodes().size());
  resize_in_threads(tensors, m.nodes().size());
  constexpr std::size_t nodes_at_once = 4096;  // for a thread
  parallel_chunks(places.size(), nodes_at_once,
                  [&](std::size_t, std::size_t begin, std::size_t end) {
                    for (std::size_t v = begin; v < end; ++v) {
                      places[v] = m.nodes()[v].position;
                      tensors[v] = m.nodes()[v].metric;
                    }
                  });
  const std::vector<graph_edge> edges = edges_of(m);
  gradation_limit limit;
  limit.distortion = distortion;
  limit.unit = unit;
  limit.shortest = 0.5;
  grade(places, edges, limit, tensors, stop);
  m.each_node([&](vertex_index v) {
    if (!identical(tensors[v], m.at(v).metric)) m.set_metric(v, tensors[v]);
  });
}

background_metric field_of(editable_mesh& m) {
  const auto is_node = [&m](std::size_t v) { return m.nodes()[v].kind != node_kind::gone; };
  const auto is_face = [&m](std::size_t t) { return m.faces()[t].exists(); };
  const present_numbers nodes = number_present(m.nodes().size(), is_node),
                        faces = number_present(m.faces().size(), is_face);
  std::vector<point> places;
  std::vector<metric_tensor> tensors;
  resize_in_threads(places, nodes.count);
  resize_in_threads(tensors, nodes.count);
  m.each_node([&](vertex_index v) {
    const node& n = m.at(v);
    places[nodes.of[v]] = n.position;
    tensors[nodes.of[v]] = n.metric;
  });
  std::vector<triangle> triangles;
  triangle_locator::corner_links across;
  resize_in_threads(triangles, faces.count);
  resize_in_threads(across, faces.count);
  constexpr std::size_t faces_at_once = 4096;  // for a thread
  parallel_chunks(
      m.faces().size(), faces_at_once, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          const face& f = m.faces()[t];
          for (std::size_t i = 0; f.exists() && i < 3; ++i) {
            triangles[faces.of[t]][i] = nodes.of[f.v[i]];
            across[faces.of[t]][i] = f.next[i] == none ? no_triangle : faces.of[f.next[i]];
          }
        }
      });
  // Sets the hint of each node to the last face at it, in one thread, as their order counts.
  for (std::size_t t = 0; t < m.faces().size(); ++t)
    if (is_face(t))
      for (const vertex_index v : m.faces()[t].v) m.at(v).hint = faces.of[t];
  return {std::make_shared<const triangle_locator>(std::move(places), std::move(triangles),
                                                   std::move(across)),
          std::move(tensors)};
}

namespace {

// Locates the nodes of a range, from each node to its neighbours, so that each search begins an
// edge away. Nodes without a neighbour in the range, as the last splits made, are searched from the
// bins of the field: from each other they may be as far as the mesh is wide.
void look_up_stretch(editable_mesh& m, const background_metric& field, vertex_index begin,
                     vertex_index end) {
  std::vector<char> is_reached(end - begin, 0);
  std::vector<vertex_index> waiting;
  face_list ring;
  std::size_t looked_at = 0;  // triangles of the field
  for (vertex_index first = begin; first < end; ++first) {
    if (m.at(first).kind == node_kind::gone || is_reached[first - begin] != 0) continue;
    m.at(first).hint = none;
    is_reached[first - begin] = 1;
    waiting.assign(1, first);
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const vertex_index v = waiting[next];
      m.at(v).hint = field.triangle_near(m.at(v).position, m.at(v).hint, looked_at);
      m.neighbours(v, ring);
      for (const vertex_index w : ring) {
        if (w < begin || w >= end || is_reached[w - begin] != 0) continue;
        is_reached[w - begin] = 1;
        m.at(w).hint = m.at(v).hint;
        m.prefetch_face_at(w);
        waiting.push_back(w);
      }
    }
  }
  m.note_looked_at(looked_at);
}

}  // namespace

void look_up_anew(editable_mesh& m, const background_metric& field) {
  constexpr std::size_t stretch = 8192;  // nodes: a block's follow each other (mesh_blocks.hpp)
  const std::size_t count = m.nodes().size(), stretches = chunk_count(count, stretch);
  // Begins with the last stretch, which takes longest: nodes made by the last splits are far from
  // each other.
  parallel_for(stretches, [&](std::size_t i) {
    const std::size_t begin = (stretches - 1 - i) * stretch, end = std::min(count, begin + stretch);
    look_up_stretch(m, field, static_cast<vertex_index>(begin), static_cast<vertex_index>(end));
  });
}

void clip_distortion_at(editable_mesh& m, const std::vector<vertex_index>& nodes, double part,
                        const std::function<void(vertex_index, vertex_index)>& changed) {
  double most = 0;
  for (const vertex_index v : nodes)
    for (const vertex_index w : nodes)
      if (v < w) most = std::max(most, log_distortion(m.at(v).metric, m.at(w).metric));
  // Least log distortion that is worth a change. A change of 1e-9 in lengths changes a clearance by
  // a few times 1e-9, some millionths of the least clearance (local_tests.hpp).
  constexpr double least = 1e-9;
  if (!(most > least)) return;
  for (const vertex_index v : nodes)
    for (const vertex_index w : nodes) {
      if (v >= w) continue;
      metric_tensor p = m.at(v).metric, q = m.at(w).metric;
      if (!clip_distortion(p, q, part * most)) continue;
      m.set_metric(v, p);
      m.set_metric(w, q);
      changed(v, w);
    }
}

}  // namespace asterism::internal::adapting
