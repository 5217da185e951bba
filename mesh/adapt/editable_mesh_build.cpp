// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "asterism/mesh/adapt/editable_mesh.hpp"

namespace asterism::internal::adapting {
namespace {

// A directed edge, and the face on its left.
struct half_edge {
  vertex_index a, b, face, edge;
  friend bool operator<(const half_edge& p, const half_edge& q) {
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  }
};

const half_edge* find(const std::vector<half_edge>& sorted, vertex_index a, vertex_index b) {
  const half_edge key{a, b, 0, 0};
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), key);
  return at != sorted.end() && at->a == a && at->b == b ? &*at : nullptr;
}

}  // namespace

result<editable_mesh> editable_mesh::build(const domain& d, const mesh& start) {
  editable_mesh made(d);
  if (auto failure = made.add(start)) return *failure;
  return made;
}

std::optional<error> editable_mesh::add(const mesh& start) {
  const auto refuse = [](const std::string& what) {
    return error{"what is to be adapted is no triangulation of the domain: " + what};
  };
  if (start.given != domain_->vertices.size() || !start.disagreeing.empty())
    return refuse("sites are missing, or triangles disagree");
  for (const site& s : start.sites) {
    const vertex_index v = new_node(s.position, node_kind::free);
    if (v < start.given) nodes_[v].kind = node_kind::given;
    set_metric(v, s.metric);
  }
  std::vector<half_edge> edges;
  for (const triangle& t : start.triangles) {
    if (!turns_left(nodes_[t[0]].position, nodes_[t[1]].position, nodes_[t[2]].position))
      return refuse("a triangle does not turn left, as far as doubles can tell");
    const vertex_index f = new_face();
    set(f, t, {none, none, none}, {none, none, none});
    for (vertex_index i = 0; i < 3; ++i) edges.push_back({t[after(i)], t[before(i)], f, i});
  }
  std::sort(edges.begin(), edges.end());
  for (const half_edge& e : edges)
    if (const half_edge* const twin = find(edges, e.b, e.a))
      faces_[e.face].next[e.edge] = twin->face;
  for (const boundary_edge& p : start.boundary) {
    const half_edge *const left = find(edges, p.a, p.b), *const right = find(edges, p.b, p.a);
    if (left == nullptr || (p.internal && right == nullptr))
      return refuse(fmt::format("piece {} - {} is no edge of it", p.a + 1, p.b + 1));
    for (const half_edge* const side : {left, right})
      if (side != nullptr) faces_[side->face].segment[side->edge] = p.segment;
    for (const vertex_index v : {p.a, p.b})
      if (nodes_[v].kind != node_kind::given) {
        nodes_[v].kind = node_kind::sliding;
        nodes_[v].segment = p.segment;
      }
  }
  for (const node& n : nodes_)
    if (n.face == none) return refuse("a site is in no triangle");
  // Moves sliding nodes of chords onto their curves, also beside sharp corners, where chords are
  // split on their own line: between such a node and one on the curve the boundary would follow
  // neither.
  for (vertex_index v = 0; v < nodes_.size(); ++v) {
    if (nodes_[v].kind != node_kind::sliding) continue;
    if (!curves_->is_chord(nodes_[v].segment)) continue;
    const point place = on_segment(v, nodes_[v].position);
    if (!can_move(v, place)) return refuse("a site cannot be brought to its curve");
    move(v, place);
  }
  return std::nullopt;
}

}  // namespace asterism::internal::adapting
