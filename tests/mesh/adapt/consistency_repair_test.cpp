// SPDX-License-Identifier: MIT
//
// Repairs meshes whose edges do not agree.
#include "asterism/mesh/adapt/consistency_repair.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <utility>

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::adapting;

namespace {

constexpr vertex_index cells = 6;

domain square_of_cells() {
  domain d;
  constexpr double side = cells;
  d.vertices = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  d.segments = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}};
  return d;
}

// Returns the square cut in cells, each of them in two, in one metric: the four nodes of each cell
// are on a circle. The square's corners are the first nodes.
mesh grid(const metric_tensor& metric) {
  mesh m;
  m.given = 4;
  std::map<std::pair<vertex_index, vertex_index>, vertex_index> number = {
      {{0, 0}, 0}, {{cells, 0}, 1}, {{cells, cells}, 2}, {{0, cells}, 3}};
  for (vertex_index i = 0; i <= cells; ++i)
    for (vertex_index j = 0; j <= cells; ++j)
      number.try_emplace({i, j}, static_cast<vertex_index>(number.size()));
  m.sites.resize(number.size());
  for (const auto& [at, v] : number)
    m.sites[v] = {{static_cast<double>(at.first), static_cast<double>(at.second)}, metric};
  for (vertex_index i = 0; i < cells; ++i) {
    m.boundary.push_back({number[{i, 0}], number[{i + 1, 0}], 0, 1});
    m.boundary.push_back({number[{cells, i}], number[{cells, i + 1}], 1, 1});
    m.boundary.push_back({number[{i + 1, cells}], number[{i, cells}], 2, 1});
    m.boundary.push_back({number[{0, i + 1}], number[{0, i}], 3, 1});
    for (vertex_index j = 0; j < cells; ++j) {
      const vertex_index a = number[{i, j}], b = number[{i + 1, j}], c = number[{i + 1, j + 1}],
                         d = number[{i, j + 1}];
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  }
  m.regions.assign(m.triangles.size(), 0);
  return m;
}

}  // namespace

TEST_CASE("the edges of a grid, whose cells are on circles, agree after the repair") {
  const domain d = square_of_cells();
  for (const metric_tensor& metric : {metric_tensor{1, 0, 1}, metric_tensor{4, 0, 1}}) {
    auto built = editable_mesh::build(d, grid(metric));
    REQUIRE(built.ok());
    editable_mesh m = std::move(built).value();
    repair_options options;
    options.wanted = [&metric](const point&) { return metric; };
    consistency_repair agreeing(m, options);
    agreeing.run();
    CHECK(agreeing.report().disagreeing == 0);
    CHECK(agreeing.report().low == 0);
    CHECK(agreeing.report().moves > 0);
    CHECK(agreeing.report().rounds < 10);
    const local_tests tests(m, options.angle_bound);
    for (vertex_index t = 0; t < m.faces().size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const face& f = m.faces()[t];
        if (f.exists() && f.next[i] != none && f.segment[i] == none)
          CHECK(tests.worst_clearance(tests.quad_at(t, i)) > least_clearance);
      }
  }
}

TEST_CASE("where others pass, edges are tested at the nodes that disagreed alone") {
  const domain d = square_of_cells();
  const metric_tensor metric{1, 0, 1};
  auto built = editable_mesh::build(d, grid(metric));
  REQUIRE(built.ok());
  editable_mesh m = std::move(built).value();
  repair_options options;
  options.most_rounds = 1;
  options.wanted = [&metric](const point&) { return metric; };
  consistency_repair agreeing(m, options);
  agreeing.restart(true);
  agreeing.run();
  CHECK(agreeing.report().disagreeing == 0);
  CHECK(agreeing.report().moves == 0);

  vertex_index corner = 0;  // of one cell alone
  while (m.at(corner).position != point{1, 1}) ++corner;
  agreeing.disagreed_at({corner});
  agreeing.run();
  CHECK(agreeing.report().moves > 0);
  constexpr double reach = 3;  // cells
  for (const node& n : m.nodes()) {
    const bool is_near = n.position.x < reach && n.position.y < reach;
    const bool is_in_grid = n.position.x == static_cast<int>(n.position.x) &&
                            n.position.y == static_cast<int>(n.position.y);
    CHECK((is_near || is_in_grid));
  }
}

TEST_CASE("a repair that holds the boundary moves and merges no node on it") {
  const domain d = square_of_cells();
  const metric_tensor metric{1, 0, 1};
  repair_options options;
  options.angle_bound = 25;
  options.wanted = [&metric](const point&) { return metric; };
  for (const bool holds : {false, true}) {
    auto built = editable_mesh::build(d, grid(metric));
    REQUIRE(built.ok());
    editable_mesh m = std::move(built).value();
    // Brings the nodes of the first row near the side below: the triangles between have low angles.
    for (vertex_index v = 0; v < m.nodes().size(); ++v)
      if (m.at(v).kind == node_kind::free && m.at(v).position.y == 1)
        m.move(v, {m.at(v).position.x + 0.3, 0.2});
    const std::vector<node> before = m.nodes();
    consistency_repair agreeing(m, options);
    agreeing.hold_boundary(holds);
    agreeing.run();
    std::size_t changed = 0;
    for (vertex_index v = 0; v < before.size(); ++v)
      if (before[v].kind == node_kind::sliding &&
          (m.at(v).kind != node_kind::sliding || !(m.at(v).position == before[v].position)))
        ++changed;
    INFO(agreeing.report().moves << " moves, " << agreeing.report().merges << " merges");
    CHECK(agreeing.report().moves > 0);
    CHECK((changed == 0) == holds);
  }
}
