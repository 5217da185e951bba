// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/curved_triangles.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/core/random.hpp"

using namespace asterism;

namespace {

mesh one_triangle(point a, point b, point c) {
  mesh m;
  m.sites = {{a, {1, 0, 1}}, {b, {1, 0, 1}}, {c, {1, 0, 1}}};
  m.triangles = {{0, 1, 2}};
  m.boundary = {{0, 1, 0, 1, false}, {1, 2, 1, 1, false}, {2, 0, 2, 1, false}};
  return m;
}

// Returns the determinant of the map at barycentric coordinates, from its shape functions and the
// product rule. It does not use control points, which the code under test does.
double determinant_at(const mesh& m, const std::array<point, 3>& nodes, double u, double v) {
  const double w = 1 - u - v;  // coordinate of the first corner; u and v are the others'
  const std::array<double, 6> by_u = {1 - 4 * w, 4 * u - 1, 0, 4 * (w - u), 4 * v, -4 * v};
  const std::array<double, 6> by_v = {1 - 4 * w, 0, 4 * v - 1, -4 * u, 4 * u, 4 * (w - v)};
  point along_u{0, 0}, along_v{0, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    const point& p = i < 3 ? m.sites[i].position : nodes[i - 3];
    along_u = {along_u.x + by_u[i] * p.x, along_u.y + by_u[i] * p.y};
    along_v = {along_v.x + by_v[i] * p.x, along_v.y + by_v[i] * p.y};
  }
  return along_u.x * along_v.y - along_u.y * along_v.x;
}

std::vector<side_node> sides(const std::array<point, 3>& nodes) {
  return {{0, 1, nodes[0]}, {0, 2, nodes[2]}, {1, 2, nodes[1]}};
}

}  // namespace

TEST_CASE("a triangle with straight sides has the Jacobian of the straight one") {
  const mesh m = one_triangle({0.1, 0.2}, {1.3, 0.3}, {0.4, 0.9});
  const second_order_report report = prove_second_order(m, {}, nullptr);
  CHECK(report.proved());
  CHECK(report.curved_sides == 0);
  CHECK(report.least_jacobian <= 1);
  CHECK(report.least_jacobian > 1 - 1e-12);
}

TEST_CASE("the bound of the Jacobian is below every value and near the least") {
  internal::splitmix64 random(20);
  int proved = 0, folded = 0;
  for (int round = 0; round < 300; ++round) {
    INFO("round " << round);
    const mesh m = one_triangle({0, 0}, {1, 0}, {random.real(-1, 1), random.real(0.3, 1)});
    std::array<point, 3> nodes;
    for (std::size_t i = 0; i < 3; ++i) {
      const point middle = middle_of_side(m.sites[i].position, m.sites[(i + 1) % 3].position);
      nodes[i] = {middle.x + random.real(-0.2, 0.2), middle.y + random.real(-0.2, 0.2)};
    }
    const second_order_report report = prove_second_order(m, sides(nodes), nullptr);
    CHECK(report.undecided.empty());
    const double straight = m.sites[2].position.y;
    double least = 1e9;
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        least = std::min(least, determinant_at(m, nodes, double(i) / steps, double(j) / steps));
    if (least <= 0) {
      CHECK(report.folded == std::vector<vertex_index>{0});
      ++folded;
    }
    if (!report.proved()) continue;
    ++proved;
    CHECK(report.least_jacobian > 0);
    CHECK(report.least_jacobian <= least / straight + 1e-12);
  }
  // The random triangles contained both kinds.
  CHECK(proved > 50);
  CHECK(folded > 50);
}

TEST_CASE("a triangle whose coefficients do not decide is halved until they do") {
  // The coefficient of the side 01 is negative, though the determinant is positive everywhere.
  const mesh m = one_triangle({0, 0}, {1, 0}, {0, 1});
  const std::array<point, 3> nodes = {point{0.5, 0.3}, point{0.6, 0.6}, point{-0.13, 0.5}};
  const second_order_report report = prove_second_order(m, sides(nodes), nullptr);
  double least = 1e9;
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; i + j <= 100; ++j)
      least = std::min(least, determinant_at(m, nodes, i / 100.0, j / 100.0));
  INFO(least);
  CHECK(report.proved() == (least > 0));
}

TEST_CASE("a node at the quarter of its side makes the map collapse at a corner") {
  const mesh m = one_triangle({0, 0}, {1, 0}, {0, 1});
  const second_order_report report = prove_second_order(m, {{0, 1, {0.25, 0}}}, nullptr);
  CHECK(report.folded == std::vector<vertex_index>{0});
  CHECK(prove_second_order(m, {{0, 1, {0.25 + 0x1p-50, 0}}}, nullptr).proved());
}

TEST_CASE("a determinant that vanishes along a line is undecided, and takes no time") {
  // The map (u, v) -> (u + v, 0) + ... folds flat: the straight triangle has no area.
  const mesh flat = one_triangle({0, 0}, {1, 0}, {2, 0});
  CHECK(!prove_second_order(flat, {}, nullptr).proved());
  CHECK(prove_second_order(mesh{}, {}, nullptr).proved() == false);
}

TEST_CASE("nodes on a circle are counted as on it, others are not") {
  const double c = std::sqrt(0.5);
  mesh m = one_triangle({1, 0}, {c, c}, {0, 0});
  domain shape;
  shape.vertices = {{1, 0}, {c, c}, {0, 0}};
  shape.segments = {{0, 1, 1}, {1, 2, 1}, {2, 0, 1}};
  domain_curve arc;
  arc.vertices = {0, 1};
  arc.parameters = {0, 1};
  shape.curves = {arc};
  const double angle = std::acos(-1.0) / 8;
  const point on{std::cos(angle), std::sin(angle)}, off{on.x * 1.001, on.y * 1.001};
  CHECK(prove_second_order(m, {{0, 1, on}}, &shape).on_curves == 1);
  CHECK(prove_second_order(m, {{0, 1, off}}, &shape).on_curves == 0);
  CHECK(prove_second_order(m, {{0, 1, off}}, &shape).proved());
}
