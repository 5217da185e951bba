// SPDX-License-Identifier: MIT
//
// Compares what changed since a mesh was taken to be audited with a copy of the mesh.
#include "asterism/mesh/delivery/audited_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_disorder.hpp"
#include "fixtures/mesh_to_change.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

// Makes one random change of tensors, places, edges or nodes, if one is possible at the face drawn.
void change(editable_mesh& m, splitmix64& random) {
  const auto t = static_cast<vertex_index>(random.bits() % m.faces().size());
  if (!m.faces()[t].exists()) return;
  const std::size_t i = random.bits() % 3;
  const vertex_index v = m.faces()[t].v[i], w = m.faces()[t].v[after(i)];
  const node n = m.at(v);
  const point to{n.position.x + random.real(-0.01, 0.01), n.position.y + random.real(-0.01, 0.01)};
  switch (random.bits() % 4) {
    case 0:
      return m.set_metric(v, {n.metric.m11 * random.real(1, 2), n.metric.m12, n.metric.m22});
    case 1:
      if (n.kind == node_kind::free && m.can_move(v, to)) m.move(v, to);
      return;
    case 2:
      if (m.can_flip(t, i)) m.flip(t, i);
      return;
    default:
      if (n.kind != node_kind::given && m.can_merge(v, w)) m.merge(v, w);
  }
}

// Compares the present mesh with a copy, node by node and face by face.
mesh_changes changes_by_copy(const editable_mesh& before, const editable_mesh& m) {
  mesh_changes found;
  for (vertex_index v = 0; v < m.nodes().size(); ++v) {
    const node &was = before.at(v), &is = m.at(v);
    const bool has_stayed = was.kind == is.kind && was.position == is.position;
    found.are_inside = found.are_inside && (has_stayed || was.kind == node_kind::free);
    if (is.kind != node_kind::gone && !(has_stayed && identical(was.metric, is.metric)))
      found.nodes.push_back(v);
  }
  for (vertex_index t = 0; t < m.faces().size(); ++t) {
    const face& is = m.faces()[t];
    if (is.exists() && before.faces()[t].v != is.v)
      found.nodes.insert(found.nodes.end(), is.v.begin(), is.v.end());
  }
  return found;
}

void check_same(const mesh& a, const mesh& b) {
  CHECK(a.triangles == b.triangles);
  REQUIRE(a.sites.size() == b.sites.size());
  for (std::size_t s = 0; s < a.sites.size(); ++s) {
    CHECK(a.sites[s].position == b.sites[s].position);
    CHECK(identical(a.sites[s].metric, b.sites[s].metric));
  }
}

}  // namespace

TEST_CASE("what changed since a mesh was taken is what differs from a copy of it") {
  const std::uint64_t seed = 41;
  CAPTURE(seed);
  splitmix64 random(seed);
  const domain d = square();
  const mesh_options options;
  std::size_t inside = 0, at_boundary = 0;
  for (int run = 0; run < 40; ++run) {
    editable_mesh m = even_mesh(d, 0.15);
    for (int i = 0; i < 20; ++i) change(m, random);  // leaves gaps in the numbers
    audited_mesh taken(d, options);
    taken.take(m);
    CHECK(taken.changes(m).nodes.empty());
    CHECK(taken.changes(m).are_inside);
    const editable_mesh before = m;
    for (int i = 0; i < 1 + run % 8; ++i) change(m, random);
    const mesh_changes found = taken.changes(m), expected = changes_by_copy(before, m);
    CHECK(found.nodes == expected.nodes);
    CHECK(found.are_inside == expected.are_inside);
    ++(expected.are_inside ? inside : at_boundary);
    if (!expected.are_inside) continue;
    audited_mesh anew(d, options);
    anew.take(m);
    taken.take_changed(m);
    check_same(taken.subject(), anew.subject());
  }
  CHECK(inside > 0);
  CHECK(at_boundary > 0);
}

TEST_CASE("a mesh taken again for its tensors is the one taken anew") {
  const domain d = square();
  const mesh_options options;
  editable_mesh m = even_mesh(d, 0.15);
  audited_mesh taken(d, options), anew(d, options);
  taken.take(m);
  for (vertex_index v = 0; v < m.nodes().size(); v += 7) {
    const metric_tensor was = m.at(v).metric;
    m.set_metric(v, {1.5 * was.m11, was.m12, was.m22});
  }
  taken.take_tensors(m);
  anew.take(m);
  check_same(taken.subject(), anew.subject());
}
