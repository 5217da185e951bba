// SPDX-License-Identifier: MIT
//
// Compares the energies that are computed for all faces around a node at once with those of single
// triangles.
#include "asterism/mesh/adapt/node_ring.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/mesh/adapt/shape_energy.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/mesh_to_change.hpp"

using namespace asterism;
using namespace asterism::internal::adapting;

namespace {

metric_tensor turning(const point& q) {
  const double c = std::cos(3 * q.x), s = std::sin(3 * q.x), thin = 25 + 20 * q.y;
  return {c * c + thin * s * s, (1 - thin) * c * s, s * s + thin * c * c};
}

// Returns a mesh of the square with five free nodes.
editable_mesh some_mesh(const domain& d) {
  editable_mesh m = coarse_mesh(d);
  for (const point& q : {point{0.3, 0.1}, {-0.4, 0.5}, {-0.1, -0.6}, {0.6, -0.3}, {0.1, 0.6}})
    for (vertex_index t = 0; t < m.faces().size(); ++t)
      if (m.insert(t, q)) break;
  m.each_node([&](vertex_index v) { m.set_metric(v, turning(m.at(v).position)); });
  return m;
}

bool is_alike(double a, double b) { return a == b || std::abs(a - b) <= 1e-12 * std::abs(a); }

// Returns the node of a mesh with the most faces, and lists these.
vertex_index busiest(const editable_mesh& m, face_list& most) {
  vertex_index best = none;
  m.around(0, most);
  for (vertex_index v = 0; v < m.nodes().size(); ++v) {
    face_list at;
    m.around(v, at);
    if (at.size() < most.size() || m.at(v).kind != node_kind::free) continue;
    most = at;
    best = v;
  }
  return best;
}

}  // namespace

TEST_CASE("faces around a node have the energies of single triangles, wherever the node is tried") {
  const domain d = square();
  editable_mesh m = some_mesh(d);
  node_ring ring;
  node_ring::energies found;
  face_list at;
  int turned_over = 0;
  for (vertex_index v = 0; v < m.nodes().size(); ++v) {
    if (m.at(v).kind != node_kind::free) continue;
    m.around(v, at);
    REQUIRE(ring.gather(m, v, at));
    const point here = m.at(v).position;
    for (const double unit : {0.0, 0.7})
      for (const point& by : {point{0, 0}, {0.01, 0.02}, {-0.05, 0.01}, {0.6, 0.1}}) {
        m.move(v, {here.x + by.x, here.y + by.y});
        ring.measure(m.at(v), unit, found);
        double sum = 0;
        for (std::size_t k = 0; k < at.size(); ++k) {
          const auto& c = m.faces()[at[k]].v;
          const double whole = shape_energy(m.at(c[0]), m.at(c[1]), m.at(c[2]), unit);
          CHECK(is_alike(found.shape[k], shape_energy(m.at(c[0]), m.at(c[1]), m.at(c[2]), 0)));
          CHECK(is_alike(found.whole[k], whole));
          sum += whole;
          turned_over += std::isinf(whole) ? 1 : 0;
        }
        CHECK(is_alike(found.sum, sum));
      }
    m.move(v, here);
  }
  CHECK(turned_over > 0);
}

TEST_CASE("the best place in a ring of equilateral triangles is its middle") {
  const domain d = square();
  editable_mesh m = coarse_mesh(d);
  vertex_index middle = none;
  for (vertex_index t = 0; t < m.faces().size() && middle == none; ++t)
    middle = m.insert(t, {0.1, 0.2}).value_or(none);
  REQUIRE(middle != none);
  // A ring of three: the middle of an equilateral triangle.
  face_list at;
  m.around(middle, at);
  REQUIRE(at.size() == 3);
  constexpr double third = 2.0943951023931953;  // of a turn
  for (std::size_t k = 0; k < 3; ++k) {
    const face& f = m.faces()[at[k]];
    const double turn = third * static_cast<double>(k);
    m.move(f.v[after(f.corner_of(middle))], {std::cos(turn), std::sin(turn)});
  }
  m.each_node([&](vertex_index v) { m.set_metric(v, {1, 0, 1}); });
  m.move(middle, {0.2, 0.1});
  node_ring ring;
  REQUIRE(ring.gather(m, middle, at));
  node_ring::energies equal;
  for (std::size_t k = 0; k < 3; ++k) equal.whole[k] = 1;
  const point best = ring.best_place(0, equal);
  CHECK(std::abs(best.x) < 1e-12);
  CHECK(std::abs(best.y) < 1e-12);
}

TEST_CASE("a node with too many faces is not gathered") {
  const domain d = square();
  editable_mesh m = some_mesh(d);
  face_list at;
  const vertex_index v = busiest(m, at);
  node_ring ring;
  CHECK(ring.gather(m, v, at));
  at.resize(node_ring::most_faces + 1, at.front());
  CHECK_FALSE(ring.gather(m, v, at));
}
