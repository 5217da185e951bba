// SPDX-License-Identifier: MIT
//
// Makes unit meshes with the number of nodes wanted, in metrics that no coarse mesh resolves, and
// fits them to another metric.
#include "asterism/mesh/adapt/unit_mesh.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/mesh/adapt/mesh_gradation.hpp"
#include "asterism/mesh/gradation/nodal_gradation.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_to_change.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

// A thin layer along y = 0.3 x with lengths across it a thousand times as short as along it.
metric_tensor layer(const point& q, vertex_index&) {
  const double away = (q.y - 0.3 * q.x) / 0.02;
  const double across = 4 + 1e4 * std::exp(-away * away);
  return {1 + 0.09 * across, -0.3 * across, 1 + across};
}

// True if every face is counter-clockwise, and their number is that of a triangulation.
bool is_whole(const editable_mesh& m) {
  std::size_t faces = 0;
  for (const face& f : m.faces()) {
    if (!f.exists()) continue;
    ++faces;
    if (!turns_left(m.at(f.v[0]).position, m.at(f.v[1]).position, m.at(f.v[2]).position))
      return false;
  }
  return faces > m.count();
}

void fit_to_layer(editable_mesh& m, std::size_t count) {
  unit_mesh_options options;
  options.count = count;
  unit_mesh_remesher(m, options).run(layer, {});
}

}  // namespace

TEST_CASE("as many nodes are made as are wanted, within three percent") {
  const domain d = square();
  for (const std::size_t wanted : {300u, 1000u, 3000u}) {
    editable_mesh m = coarse_mesh(d);
    unit_mesh_options options;
    options.count = wanted;
    unit_mesh_remesher maker(m, options);
    maker.run(layer, {});
    maker.refit(layer);
    INFO(wanted << " nodes wanted, " << m.count() << " made");
    CHECK(std::abs(static_cast<double>(m.count()) / static_cast<double>(wanted) - 1) < 0.03);
    CHECK(is_whole(m));
  }
}

TEST_CASE("places in a fine metric were all crowded by corners in one 1e4 times as coarse") {
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  unit_mesh_options options;
  options.count = 6000;
  options.most_nodes = 4 * options.count;
  unit_mesh_remesher maker(m, options);
  const auto jump = [](const point& q, vertex_index&) {
    return q.x < 0.1 ? metric_tensor{2500, 0, 2500} : metric_tensor{2.5e-5, 0, 2.5e-5};
  };
  std::vector<point> seeds;
  constexpr int across = 160;
  for (int i = 1; i < across; ++i)
    for (int j = 1; j < across; ++j) seeds.push_back({2.0 * i / across - 1, 2.0 * j / across - 1});
  maker.run(jump, seeds);
  maker.meet_count(jump);
  CHECK(std::abs(static_cast<double>(m.count()) / 6000 - 1) < 0.03);
  CHECK(is_whole(m));
}

TEST_CASE(
    "a front that ends on a side between distant vertices divides the side at the seeds there") {
  // A layer along y = 0.3, in a metric in which a whole side is shorter than an edge.
  const auto front = [](const point& q, vertex_index&) {
    const double away = (q.y - 0.3) / 0.03;
    return metric_tensor{0.04, 0, 0.04 + 1e4 * std::exp(-away * away)};
  };
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  std::vector<point> seeds;
  for (int i = 0; i <= 20; ++i) {
    seeds.push_back({1, 0.2 + 0.01 * i});
    seeds.push_back({std::nextafter(-1.0, i % 2 == 0 ? -2.0 : 0.0), 0.2 + 0.01 * i});
  }
  unit_mesh_remesher(m, {}).run(front, seeds);
  std::size_t left = 0, right = 0;
  for (const node& n : m.nodes()) {
    if (n.kind != node_kind::sliding || std::abs(n.position.y - 0.3) > 0.03) continue;
    (n.position.x < 0 ? left : right) += 1;
  }
  CHECK(left >= 4);
  CHECK(right >= 4);
}

TEST_CASE("without a count edges have length one") {
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  unit_mesh_remesher maker(m, {});
  maker.run([](const point&, vertex_index&) { return metric_tensor{400, 0, 100}; }, {});
  CHECK(maker.unit() == 1);
  // The square has area 4, and 800 in the metric. A lattice of unit equilateral triangles has a
  // node for each 0.87 of area.
  CHECK(m.count() > 800);
  CHECK(m.count() < 1200);
}

TEST_CASE("a mesh fitted again to its own graded metric keeps its count") {
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  unit_mesh_options options;
  options.count = 1000;
  unit_mesh_remesher maker(m, options);
  maker.run(layer, {});
  grade_mesh(m, 2, maker.unit());
  const background_metric own = field_of(m);
  maker.refit([&own](const point& q, vertex_index& hint) { return own.at(q, hint); });
  CHECK(std::abs(static_cast<double>(m.count()) / 1000 - 1) < 0.03);
  CHECK(is_whole(m));
}

TEST_CASE("long edges are split up to the number of nodes that there is room for") {
  const domain d = square();
  for (const std::size_t room : {0u, 7u}) {
    editable_mesh m = coarse_mesh(d);
    unit_mesh_options options;
    options.count = 300;
    unit_mesh_remesher maker(m, options);
    const auto even = [](const point&, vertex_index&) { return metric_tensor{1, 0, 1}; };
    maker.run(even, {});
    // All edges have length 2 in the metric.
    for (vertex_index v = 0; v < m.nodes().size(); ++v) m.set_metric(v, {4, 0, 4});
    const auto finer = [](const point&, vertex_index&) { return metric_tensor{4, 0, 4}; };
    CAPTURE(room);
    const std::size_t before = m.count();
    const std::vector<node> nodes = m.nodes();
    const std::vector<face> faces = m.faces();
    const std::vector<vertex_index> changed = maker.split_left_long(finer, before + room);
    CHECK(m.count() == before + room);
    CHECK(changed.empty() == (room == 0));
    const auto is_listed = [&](vertex_index v) {
      return std::find(changed.begin(), changed.end(), v) != changed.end();
    };
    for (vertex_index v = 0; v < m.nodes().size(); ++v) {
      const bool is_as_before = v < nodes.size() && nodes[v].position == m.at(v).position;
      CHECK((is_as_before || is_listed(v)));
    }
    for (vertex_index t = 0; t < m.faces().size(); ++t)
      for (const vertex_index v : m.faces()[t].v)
        CHECK(((t < faces.size() && faces[t].v == m.faces()[t].v) || is_listed(v)));
    CHECK(is_whole(m));
  }
}

TEST_CASE("a field of a mesh's own tensors has each of them at its node") {
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  fit_to_layer(m, 200);
  const background_metric own = field_of(m);
  for (const node& n : m.nodes()) {
    if (n.kind == node_kind::gone) continue;
    vertex_index hint = n.hint;
    CHECK(log_distortion(own.at(n.position, hint), n.metric) < 1e-6);
    CHECK(hint == n.hint);
  }
}

// Returns the triangle of the field that a search from the node's hint finds.
vertex_index triangle_near(const background_metric& field, const node& n) {
  std::size_t looked_at = 0;
  return field.triangle_near(n.position, n.hint, looked_at);
}

TEST_CASE("after another field each node is looked up anew from its neighbour") {
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  fit_to_layer(m, 200);
  const background_metric wanted = field_of(m);
  unit_mesh_options options;
  options.count = 600;
  unit_mesh_remesher finer(m, options);
  finer.run([&wanted](const point& q, vertex_index& hint) { return wanted.at(q, hint); }, {});
  const background_metric own = field_of(m);
  std::size_t left = 0, there = 0;
  for (const node& n : m.nodes())
    if (n.kind != node_kind::gone && triangle_near(wanted, n) != n.hint) ++left;
  CHECK(left > 300);
  look_up_anew(m, wanted);
  for (const node& n : m.nodes())
    if (n.kind != node_kind::gone && triangle_near(wanted, n) == n.hint) ++there;
  CHECK(there == m.count());
}
