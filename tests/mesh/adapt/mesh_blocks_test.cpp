// SPDX-License-Identifier: MIT
//
// Cuts triangulations into blocks and joins them again, and makes meshes in blocks by several
// threads: the results do not depend on the number of threads.
#include "asterism/mesh/adapt/mesh_blocks.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "asterism/mesh/adapt/unit_mesh.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_to_change.hpp"
#include "fixtures/thread_arena.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

// A front along y = 0.3 x with lengths across it six times as short as along it.
metric_tensor front(const point& q, vertex_index&) {
  const double away = (q.y - 0.3 * q.x) / 0.2;
  const double across = 35 * std::exp(-away * away);
  return {1 + 0.09 * across, -0.3 * across, 1 + across};
}

domain halved_square() {
  domain d = square();
  d.vertices.push_back({-0.5, -0.25});
  d.vertices.push_back({0.5, 0.25});
  d.segments.push_back({4, 5, 7, true});
  return d;
}

editable_mesh fitted(const domain& d, std::size_t count) {
  editable_mesh m = coarse_mesh(d);
  unit_mesh_options making;
  making.count = count;
  unit_mesh_remesher(m, making).run(front, {});
  return m;
}

// Lists the faces by the places of their corners, beginning with the least.
using placed_face = std::array<std::pair<double, double>, 3>;
std::multiset<placed_face> placed_faces(const editable_mesh& m) {
  std::multiset<placed_face> all;
  for (const face& f : m.faces()) {
    if (!f.exists()) continue;
    placed_face at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = {m.at(f.v[i]).position.x, m.at(f.v[i]).position.y};
    std::rotate(at.begin(), std::min_element(at.begin(), at.end()), at.end());
    all.insert(at);
  }
  return all;
}

// True if faces refer to each other across their edges and agree about segments, and every node
// refers to a face that contains it.
bool is_linked(const editable_mesh& m) {
  for (vertex_index t = 0; t < m.faces().size(); ++t) {
    const face& f = m.faces()[t];
    for (std::size_t i = 0; i < 3 && f.exists(); ++i) {
      if (is_of_frame(f.segment[i])) return false;
      const face& at = m.faces()[m.at(f.v[i]).face];
      if (std::find(at.v.begin(), at.v.end(), f.v[i]) == at.v.end()) return false;
      if (f.next[i] == none) continue;
      const face& g = m.faces()[f.next[i]];
      const std::size_t k = after(g.corner_of(f.v[after(i)]));
      if (g.next[k] != t || g.segment[k] != f.segment[i]) return false;
    }
  }
  return true;
}

mesh triangulation_of(const editable_mesh& m) {
  std::vector<vertex_index> renumbered;
  return m.triangulation(renumbered);
}

}  // namespace

TEST_CASE("a mesh cut into blocks and put together is the same one") {
  const domain d = halved_square();
  editable_mesh m = fitted(d, 6000);
  REQUIRE(mesh_blocks::are_worth_it(m));
  const auto before = placed_faces(m);
  const std::size_t pieces = triangulation_of(m).boundary.size();
  for (const unsigned cut : {0U, 1U, 2U, 17U}) {
    INFO("cut " << cut);
    mesh_blocks blocks(m, cut);
    CHECK(blocks.count() >= 4);
    for (std::size_t b = 0; b < blocks.count(); ++b) blocks.put_back(b, blocks.take_out(b));
    blocks.join(0);
    CHECK(is_linked(m));
    CHECK(placed_faces(m) == before);
    CHECK(triangulation_of(m).boundary.size() == pieces);
  }
}

TEST_CASE("a mesh with many vertices of the domain in each block is cut and put together") {
  // Blocks may share the domain's vertices, and number them as nodes of the frame.
  constexpr int vertices = 10000;
  domain d;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices;
    d.vertices.push_back({std::cos(angle), std::sin(angle)});
    d.segments.push_back(
        {static_cast<vertex_index>(i), static_cast<vertex_index>((i + 1) % vertices), 1});
  }
  editable_mesh m = coarse_mesh(d);
  REQUIRE(mesh_blocks::are_worth_it(m));
  const auto before = placed_faces(m);
  const std::size_t count = m.count();
  mesh_blocks blocks(m, 3);
  std::ptrdiff_t most = 0;  // vertices of the domain in a block
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    mesh_blocks::block taken = blocks.take_out(b);
    const auto shared = std::count_if(taken.nodes.begin(), taken.nodes.end(),
                                      [](vertex_index v) { return v < vertices; });
    most = std::max(most, shared);
    blocks.put_back(b, std::move(taken));
  }
  CHECK(most > 600);
  blocks.join(0);
  CHECK(is_linked(m));
  CHECK(placed_faces(m) == before);
  CHECK(m.count() == count);
}

TEST_CASE("a join tells the numbers of each block's nodes and faces in the whole") {
  const domain d = halved_square();
  editable_mesh m = fitted(d, 6000);
  mesh_blocks blocks(m, 5);
  std::vector<std::vector<point>> places(blocks.count());  // of each block's nodes
  std::size_t faces = 0;
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    mesh_blocks::block taken = blocks.take_out(b);
    for (const node& n : taken.part.nodes()) places[b].push_back(n.position);
    faces += taken.part.faces().size();
    blocks.put_back(b, std::move(taken));
  }
  std::optional<mesh_blocks::size> whole;
  std::vector<mesh_blocks::numbers> all(blocks.count());
  const auto make_room = [&](const mesh_blocks::size& size) { whole = size; };
  blocks.join(0,
              {make_room, [&](std::size_t b, const mesh_blocks::numbers& now) { all[b] = now; }});
  REQUIRE(whole);
  CHECK(whole->nodes == m.nodes().size());
  CHECK(whole->faces == m.faces().size());
  CHECK(whole->faces == faces);
  std::vector<int> times(whole->faces, 0);
  for (std::size_t b = 0; b < all.size(); ++b) {
    REQUIRE(all[b].nodes.size() == places[b].size());
    for (std::size_t v = 0; v < places[b].size(); ++v)
      CHECK(m.at(all[b].nodes[v]).position == places[b][v]);
    for (const vertex_index t : all[b].faces) ++times[t];
    for (const vertex_index v : blocks.nodes_at_frame(b))
      CHECK(blocks.frame_node_now(b, v) == all[b].nodes[v]);
  }
  CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
}

TEST_CASE("a face that is gone is in no part of the curve") {
  const domain d = square();
  const editable_mesh m = coarse_mesh(d);
  std::vector<face> faces = m.faces();
  faces.insert(faces.begin(), face{});
  for (const std::size_t parts : {std::size_t{1}, std::size_t{2}}) {
    const curve_parts divided(m.nodes(), faces, d.box(), parts);
    CHECK(divided.of(0) == divided.count());
    for (vertex_index t = 1; t < faces.size(); ++t) CHECK(divided.of(t) < divided.count());
  }
}

TEST_CASE("in a block the frame has all its faces' other ends, and stays as it is") {
  const domain d = halved_square();
  editable_mesh m = fitted(d, 6000);
  const editable_mesh whole = m;
  mesh_blocks blocks(m, 3);
  std::size_t inside = 0;
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    mesh_blocks::block taken = blocks.take_out(b);
    for (vertex_index v = 0; v < taken.nodes.size(); ++v) {
      face_list here, there;
      whole.around(taken.nodes[v], there);
      if (taken.is_frame[v] != 0) {
        CHECK(taken.part.at(v).kind == node_kind::given);
        continue;
      }
      ++inside;
      taken.part.around(v, here);
      CHECK(here.size() == there.size());
      CHECK(taken.part.at(v).kind == whole.at(taken.nodes[v]).kind);
    }
    blocks.put_back(b, std::move(taken));
  }
  blocks.join(0);
  // 12 % of the 1,000 nodes of a square are on the boundary that two blocks share.
  CHECK(100 * inside > 80 * m.count());
}

TEST_CASE("a mesh fitted in blocks is the same on any number of threads", "[threads]") {
  const domain d = halved_square();
  std::vector<mesh> made;
  for (const int threads : {1, 2, 3, 7}) {
    with_threads(threads, [&] {
      const editable_mesh m = fitted(d, 6000);
      CHECK(is_linked(m));
      CHECK(std::abs(static_cast<double>(m.count()) / 6000 - 1) < 0.03);
      made.push_back(triangulation_of(m));
    });
    INFO(threads << " threads");
    CHECK(same(made.front(), made.back()));
  }
}

TEST_CASE("a mesh delivered from several blocks is the same on any number of threads",
          "[threads]") {
  const domain d = square();
  const auto field = make_metric_field("sink:6", d.box());
  REQUIRE(field.ok());
  mesh_options options;
  options.vertices = 6000;
  options.limit_size = true;
  std::vector<mesh> made;
  for (const int threads : {1, 2, 3, 7}) {
    with_threads(threads, [&] {
      auto outcome = make_mesh(d, *field.value(), options);
      REQUIRE(outcome.ok());
      CHECK(outcome.value().complete);
      CHECK(outcome.value().result.sites.size() > 5000);
      made.push_back(std::move(outcome.value().result));
    });
    INFO(threads << " threads");
    CHECK(same(made.front(), made.back()));
  }
}
