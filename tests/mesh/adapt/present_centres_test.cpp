// SPDX-License-Identifier: MIT
//
// Compares remembered Voronoi vertices with computed ones while nodes are tried at other places.
#include "asterism/mesh/adapt/present_centres.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "asterism/mesh/adapt/edges_around.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_disorder.hpp"
#include "fixtures/mesh_to_change.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

bool are_same(const face_centre& p, const face_centre& q) {
  return p.at == q.at && p.squared_radius == q.squared_radius;
}

vertex_index free_node(const editable_mesh& m) {
  for (vertex_index v = 0; v < m.nodes().size(); ++v)
    if (m.at(v).kind == node_kind::free) return v;
  return none;
}

}  // namespace

TEST_CASE("a centre is that of the face as it was until its node is accepted") {
  const domain d = square();
  editable_mesh m = even_mesh(d, 0.25);
  const local_tests tests(m, 20);
  present_centres present(m, tests);
  present.find_all();
  edges_around edges(m, tests, present);
  const vertex_index v = free_node(m);
  REQUIRE(v != none);
  edges.turn_to(v);
  const vertex_index t = edges.faces().front();
  const face_centre before = present.of(t);
  CHECK(are_same(before, tests.centre_of(t)));
  m.set_metric(v, {20, 1, 30});
  CHECK(are_same(present.of(t), before));
  CHECK_FALSE(are_same(tests.centre_of(t), before));
  const auto check_all = [&] {
    for (vertex_index s = 0; s < m.faces().size(); ++s)
      if (m.faces()[s].exists()) CHECK(are_same(present.of(s), tests.centre_of(s)));
  };
  edges.accept();
  check_all();
  // Accepts the node with centres that were computed where it was tried.
  m.set_metric(v, {5, 1, 4});
  CHECK(edges.all_of([](double, const auto&) { return true; }));
  edges.accept();
  check_all();
}

TEST_CASE("clearances do not change where a node is tried as it is") {
  const domain d = square();
  editable_mesh m = even_mesh(d, 0.25);
  const local_tests tests(m, 20);
  present_centres present(m, tests);
  edges_around edges(m, tests, present);
  for (vertex_index v = 0; v < m.nodes().size(); ++v) {
    if (m.at(v).kind == node_kind::gone) continue;
    edges.turn_to(v);
    edges.remember();
    CHECK(edges.all_of([](double now, const auto& before) { return now == before(); }));
  }
}

TEST_CASE("the distance of a node from a face across is at least the clearance of their edge") {
  const domain d = square();
  editable_mesh m = even_mesh(d, 0.25);
  const local_tests tests(m, 20);
  present_centres present(m, tests);
  edges_around edges(m, tests, present);
  std::size_t compared = 0;
  for (vertex_index v = 0; v < m.nodes().size(); ++v) {
    if (m.at(v).kind == node_kind::gone) continue;
    edges.turn_to(v);
    edges.remember();
    CHECK(edges.all_across([&](double now, const auto& before) {
      ++compared;
      return now >= before();
    }));
    CHECK(!edges.all_across([](double, const auto&) { return false; }));
  }
  CHECK(compared > m.count());
}

TEST_CASE("clearances before are those of the node as it was remembered") {
  const domain d = square();
  editable_mesh m = even_mesh(d, 0.25);
  const local_tests tests(m, 20);
  present_centres present(m, tests);
  edges_around edges(m, tests, present);
  const vertex_index v = free_node(m);
  REQUIRE(v != none);
  const metric_tensor as_it_was = m.at(v).metric, tried{20, 1, 30};
  edges.turn_to(v);
  edges.remember();
  std::vector<double> expected, found;
  CHECK(edges.all_of([&](double now, const auto&) {
    expected.push_back(now);
    return true;
  }));
  m.set_metric(v, tried);
  std::size_t others = 0;
  CHECK(edges.all_of([&](double now, const auto& before) {
    found.push_back(before());
    others += now != found.back();
    return true;
  }));
  CHECK(found == expected);
  CHECK(others > 3);
  CHECK(identical(m.at(v).metric, tried));
  m.set_metric(v, as_it_was);
  for (const vertex_index t : edges.faces()) CHECK(are_same(present.of(t), tests.centre_of(t)));
}
