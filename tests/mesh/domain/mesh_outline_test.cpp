// SPDX-License-Identifier: MIT
//
// Finds the domain of a mesh. It has all required vertices and few others, and the domain of a mesh
// of that domain is the same.
#include "asterism/mesh/domain/mesh_outline.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "asterism/mesh/domain/outline_points.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using internal::enclosed_sizes;
using tests::divided_mesh;
using tests::sample_mesh;

namespace {

mesh_outline outline(const mesh& m, const mesh_marks& marks = {}, double angle = 30) {
  auto found = outline_of_mesh(m, marks, {angle, {}});
  REQUIRE(found.ok());
  return std::move(found).value();
}

// n vertices on a circle around the origin and a triangle from each side to the origin, in a metric
// of this size.
mesh disc(vertex_index n, double size) {
  mesh m;
  for (vertex_index i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    m.sites.push_back({{std::cos(t), std::sin(t)}, {1 / (size * size), 0, 1 / (size * size)}});
  }
  m.sites.push_back({{0, 0}, {1, 0, 1}});
  for (vertex_index i = 0; i < n; ++i) {
    m.triangles.push_back({i, (i + 1) % n, n});
    m.boundary.push_back({i, (i + 1) % n, i, 7});
  }
  return m;
}

// Cells of a grid with n in a row, without the cells that `plan` marks by a dot. The boundary has
// the mesh on its left. `plan` lists the lowest row first.
mesh cells(int n, const std::string& plan) {
  mesh m;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) m.sites.push_back({{1.0 * i, 1.0 * j}, {1, 0, 1}});
  const auto is_there = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < n && j < n && plan[static_cast<std::size_t>(n * j + i)] != '.';
  };
  const auto edge = [&](int a, int b) {
    m.boundary.push_back({static_cast<vertex_index>(a), static_cast<vertex_index>(b), 0, 1});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      if (!is_there(i, j)) continue;
      const int a = (n + 1) * j + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      const auto at = [](int v) { return static_cast<vertex_index>(v); };
      m.triangles.push_back({at(a), at(b), at(c)});
      m.triangles.push_back({at(a), at(c), at(d)});
      if (!is_there(i, j - 1)) edge(a, b);
      if (!is_there(i + 1, j)) edge(b, c);
      if (!is_there(i, j + 1)) edge(c, d);
      if (!is_there(i - 1, j)) edge(d, a);
    }
  return m;
}

}  // namespace

TEST_CASE("of a square's mesh its corners stay, with the markers of its sides") {
  const auto found = outline(sample_mesh(9));
  REQUIRE(found.shape.vertices.size() == 4);
  REQUIRE(found.shape.segments.size() == 4);
  CHECK(found.boundary_vertices == 36);
  CHECK(found.kept == 4);
  CHECK_FALSE(found.keeps_all);
  std::vector<int> markers;
  for (const segment& s : found.shape.segments) markers.push_back(s.marker);
  std::sort(markers.begin(), markers.end());
  CHECK(markers == std::vector<int>{1, 2, 3, 4});
  REQUIRE(found.segment_of_edge.size() == 36);
  const mesh m = sample_mesh(9);
  for (std::size_t e = 0; e < 36; ++e)
    CHECK(found.shape.segments[found.segment_of_edge[e]].marker == m.boundary[e].marker);
}

TEST_CASE("marked vertices and ends of marked edges stay, inner ones too") {
  const mesh m = sample_mesh(6);
  mesh_marks marks;
  marks.required_vertices = {30};  // inside
  marks.corners = {m.boundary[4].a};
  marks.required_edges = {{m.boundary[8].a, m.boundary[8].b}};
  const auto found = outline(m, marks);
  const auto has = [&](vertex_index v) {
    return std::count(found.shape.vertices.begin(), found.shape.vertices.end(),
                      m.sites[v].position) == 1;
  };
  for (const vertex_index v : {vertex_index{30}, m.boundary[4].a, m.boundary[8].a, m.boundary[8].b})
    CHECK(has(v));
  CHECK(found.shape.vertices.size() == 8);
}

TEST_CASE("an end of a run of one marker stays where the boundary is straight") {
  mesh m = sample_mesh(8);
  for (boundary_edge& e : m.boundary)
    if (e.marker == 1 && m.sites[e.a].position.x < 0) e.marker = 9;
  CHECK(outline(m).shape.vertices.size() == 5);
}

TEST_CASE("internal segments and regions stay") {
  const mesh m = divided_mesh(6);
  const auto found = outline(m);
  CHECK(found.shape.segments.size() == 5 + (found.shape.vertices.size() - 4));
  REQUIRE(found.shape.regions.size() == 2);
  CHECK(found.shape.regions[0].number + found.shape.regions[1].number == -5);
}

TEST_CASE("a curved boundary follows the polygon, coarser where the metric is") {
  const auto fine = outline(disc(200, 0.02)), coarse = outline(disc(200, 0.5));
  CHECK(fine.shape.vertices.size() == 200);
  // A piece over k edges, which turn by 1.8 degrees each, leaves its arc by k * 0.39 % of its
  // length: at most two edges.
  CHECK(coarse.shape.vertices.size() <= 102);
  CHECK(coarse.greatest_distance < 0.01);
  // The boundary turns at every vertex by more than a degree.
  CHECK(outline(disc(200, 0.5), {}, 1).shape.vertices.size() == 200);
}

TEST_CASE("where edges wanted are longer, pieces are three hundredths of their length away") {
  // An arc of t radians is t / 8 of its chord high: 0.24 radians are 7 edges of the polygon, and
  // with a hundredth 0.08 radians 2.
  const mesh m = disc(200, 4);
  CHECK(outline(m).shape.vertices.size() <= 30);
  CHECK(outline(m).greatest_distance < 0.03 * 0.24);
  outline_options how;
  how.part_of_length = 0.01;
  REQUIRE(outline_of_mesh(m, {}, how).ok());
  CHECK(outline_of_mesh(m, {}, how).value().shape.vertices.size() >= 100);
}

TEST_CASE("pieces of a curved boundary are cubics through its vertices, near to the circle") {
  const auto found = outline(disc(32, 0.02));
  REQUIRE(found.shape.curves.size() == 32);
  for (const domain_curve& c : found.shape.curves) {
    REQUIRE(c.vertices.size() == 2);
    const point &a = found.shape.vertices[c.vertices[0]], &b = found.shape.vertices[c.vertices[1]];
    const point middle{(a.x + 3 * c.control[0].x + 3 * c.control[1].x + b.x) / 8,
                       (a.y + 3 * c.control[0].y + 3 * c.control[1].y + b.y) / 8};
    // The chord is 4.8e-3 from the vertex.
    CHECK(std::abs(std::hypot(middle.x, middle.y) - 1) < 1e-8);
  }
}

TEST_CASE("the distance that is asked for is kept by what goes and by cubics") {
  const double height = 1 - std::cos(std::numbers::pi / 32);
  const auto at_most = [&](double distance, double size) {
    auto found = outline_of_mesh(disc(32, size), {}, {30, distance});
    REQUIRE(found.ok());
    return std::move(found).value();
  };
  CHECK(at_most(1.01 * height, 0.02).shape.curves.size() == 32);
  CHECK(at_most(0.9 * height, 0.02).shape.curves.empty());
  CHECK(at_most(0.9 * height, 0.02).shape.vertices.size() == 32);
  const auto coarse = at_most(0.1, 2);
  CHECK(coarse.shape.vertices.size() < 12);
  CHECK(coarse.greatest_distance <= 0.1);
  std::size_t gone = 0;
  for (const auto& one : coarse.former.between) gone += one.size();
  CHECK(gone + coarse.shape.vertices.size() == 32);
  CHECK(at_most(1e-6, 2).shape.vertices.size() == 32);
  CHECK_FALSE(outline_of_mesh(disc(32, 1), {}, {30, 1e-15}).ok());
}

TEST_CASE("a greater part of the size lets more vertices go") {
  const auto of_part = [](double part) {
    outline_options how;
    how.part_of_length = how.part_of_size = part;
    return outline_of_mesh(disc(128, 2), {}, how);
  };
  // The arc of a piece may turn by eight times the part, in radians: by 22.9 degrees for 0.05 and
  // 4.6 for 0.01. Each edge of the polygon turns by 2.8 degrees.
  REQUIRE(of_part(0.05).ok());
  CHECK(of_part(0.05).value().shape.vertices.size() <= 21);
  CHECK(of_part(0.05).value().part_of_size == 0.05);
  CHECK(of_part(0.01).value().shape.vertices.size() == 128);
  CHECK_FALSE(of_part(0).ok());
  CHECK_FALSE(of_part(0.126).ok());
}

TEST_CASE("vertices go by the size across the boundary, not by that along it") {
  mesh m = disc(400, 0.5);
  CHECK(outline(m).shape.vertices.size() < 250);
  // Layers along the wall: sizes are 0.5 along it and 0.005 across it.
  for (site& s : m.sites) {
    const point& p = s.position;
    const double across = 1 / (0.005 * 0.005), along = 4;
    s.metric = {across * p.x * p.x + along * p.y * p.y, (across - along) * p.x * p.y,
                across * p.y * p.y + along * p.x * p.x};
  }
  const auto found = outline(m);
  CHECK(found.greatest_distance < 0.005 / 100);
  CHECK(found.shape.vertices.size() == 400);
}

TEST_CASE("sides of several edges are not bent where they meet at a flat angle") {
  // A polygon with twelve sides of three edges each. Its corners turn by 30 degrees.
  mesh m;
  const auto corner = [](int k) {
    const double t = 2 * std::numbers::pi * k / 12;
    return point{std::cos(t), std::sin(t)};
  };
  for (int k = 0; k < 12; ++k)
    for (int i = 0; i < 3; ++i) {
      const point a = corner(k), b = corner(k + 1);
      m.sites.push_back({{a.x + i * (b.x - a.x) / 3, a.y + i * (b.y - a.y) / 3}, {1e4, 0, 1e4}});
    }
  m.sites.push_back({{0, 0}, {1, 0, 1}});
  for (vertex_index i = 0; i < 36; ++i) {
    m.triangles.push_back({i, (i + 1) % 36, 36});
    m.boundary.push_back({i, (i + 1) % 36, i, 7});
  }
  CHECK(outline(m, {}, 31).shape.curves.empty());
}

TEST_CASE("a curve is not bent by the straight side that it meets at a flat angle") {
  // 62 of 72 vertices of a circle, and a straight side of four edges in place of the others. The
  // curve turns by 27.5 degrees at the ends of the side, and by five elsewhere.
  mesh m;
  const auto on_circle = [](int k) {
    const double t = 2 * std::numbers::pi * k / 72;
    return point{std::cos(t), std::sin(t)};
  };
  for (int k = 5; k <= 67; ++k) m.sites.push_back({on_circle(k), {1e4, 0, 1e4}});
  const point a = on_circle(67), b = on_circle(5);
  for (int i = 1; i < 4; ++i)
    m.sites.push_back({{a.x + i * (b.x - a.x) / 4, a.y + i * (b.y - a.y) / 4}, {1e4, 0, 1e4}});
  const auto n = static_cast<vertex_index>(m.sites.size());
  m.sites.push_back({{0, 0}, {1, 0, 1}});
  for (vertex_index i = 0; i < n; ++i) {
    m.triangles.push_back({i, (i + 1) % n, n});
    m.boundary.push_back({i, (i + 1) % n, i, i < 62 ? 7 : 8});
  }
  const auto found = outline(m);
  REQUIRE(found.shape.curves.size() == 62);
  for (const domain_curve& c : found.shape.curves) {
    const point &p = found.shape.vertices[c.vertices[0]], &q = found.shape.vertices[c.vertices[1]];
    const point middle{(p.x + 3 * c.control[0].x + 3 * c.control[1].x + q.x) / 8,
                       (p.y + 3 * c.control[0].y + 3 * c.control[1].y + q.y) / 8};
    CHECK(std::abs(std::hypot(middle.x, middle.y) - 1) < 1e-8);  // the chord is 9.5e-4 from it
  }
}

TEST_CASE("a cubic that has something else in its way stays straight") {
  // Makes a thin ring of two rows of vertices: its inner side is within 1e-4 of its outer side.
  const vertex_index n = 24;
  mesh m;
  for (const double r : {1.0, 0.9999})
    for (vertex_index i = 0; i < n; ++i) {
      const double t = 2 * std::numbers::pi * i / n;
      m.sites.push_back({{r * std::cos(t), r * std::sin(t)}, {1e4, 0, 1e4}});
    }
  for (vertex_index i = 0; i < n; ++i) {
    const vertex_index j = (i + 1) % n;
    m.triangles.push_back({i, j, n + i});
    m.triangles.push_back({j, n + j, n + i});
    m.boundary.push_back({i, j, i, 1});
    m.boundary.push_back({n + j, n + i, n + i, 2});
  }
  const auto found = outline(m);
  CHECK_FALSE(found.keeps_all);
  // Two cubics of the inner side would cross the outer chords.
  CHECK(found.shape.curves.size() < 2 * n);
}

TEST_CASE("holes stay holes") {
  // A square ring: cells of a grid without the middle one.
  mesh m;
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i <= 3; ++i) m.sites.push_back({{1.0 * i, 1.0 * j}, {1, 0, 1}});
  const auto edge = [&](int a, int b) {
    m.boundary.push_back({static_cast<vertex_index>(a), static_cast<vertex_index>(b), 0, 1});
  };
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      if (i == 1 && j == 1) continue;
      const auto a = static_cast<vertex_index>(4 * j + i);
      m.triangles.push_back({a, a + 1, a + 5});
      m.triangles.push_back({a, a + 5, a + 4});
    }
  for (int i = 0; i < 3; ++i) {
    edge(i, i + 1);
    edge(4 * i + 3, 4 * i + 7);
    edge(15 - i, 14 - i);
    edge(12 - 4 * i, 8 - 4 * i);
  }
  edge(5, 9), edge(9, 10), edge(10, 6), edge(6, 5);
  const auto found = outline(m);
  CHECK(found.shape.vertices.size() == 8);
  CHECK(found.shape.segments.size() == 8);
  CHECK_FALSE(found.keeps_all);
}

TEST_CASE("holes that touch in a corner let go of what lies between corners") {
  // Two holes of 2 by 2 cells each; the vertex they share is a corner of both.
  const auto found = outline(cells(6,
                                   "oooooo"
                                   "o..ooo"
                                   "o..ooo"
                                   "ooo..o"
                                   "ooo..o"
                                   "oooooo"));
  CHECK_FALSE(found.keeps_all);
  CHECK(found.shape.vertices.size() == 4 + 4 + 4 - 1);
  CHECK(found.shape.segments.size() == 12);
  CHECK(found.shape.holes.size() == 2);
}

TEST_CASE("a hole that touches the outer boundary, and parts that touch, let go as well") {
  const auto dented = outline(cells(6,
                                    "..oooo"
                                    "..oooo"
                                    "oo..oo"
                                    "oo..oo"
                                    "oooooo"
                                    "oooooo"));
  CHECK_FALSE(dented.keeps_all);
  CHECK(dented.shape.vertices.size() == 6 + 3);
  CHECK(dented.shape.holes.size() == 1);
  const auto parts = outline(cells(4,
                                   "oo.."
                                   "oo.."
                                   "..oo"
                                   "..oo"));
  CHECK_FALSE(parts.keeps_all);
  CHECK(parts.shape.vertices.size() == 7);
  CHECK(parts.shape.holes.empty());
}

TEST_CASE("an island that touches the hole around it stays") {
  const auto found = outline(cells(6,
                                   "oooooo"
                                   "o....o"
                                   "o....o"
                                   "o..o.o"
                                   "o...oo"
                                   "oooooo"));
  CHECK_FALSE(found.keeps_all);
  CHECK(enclosed_sizes(found.shape).at(1) == 36 - 14);
}

TEST_CASE("marks of vertices that do not exist are refused") {
  const mesh m = sample_mesh(3);
  mesh_marks marks;
  marks.corners = {99};
  CHECK_FALSE(outline_of_mesh(m, marks, {}).ok());
  CHECK_FALSE(outline_of_mesh(m, {}, {0, {}}).ok());
}

TEST_CASE("a curved line between regions keeps its vertices, one within a region does not") {
  // A disc in a ring, of triangles between a centre and two circles.
  constexpr vertex_index n = 256;
  mesh m;
  for (const double radius : {0.5, 1.0})
    for (vertex_index i = 0; i < n; ++i) {
      const double t = 2 * std::numbers::pi * i / n;
      m.sites.push_back({{radius * std::cos(t), radius * std::sin(t)}, {1, 0, 1}});
    }
  m.sites.push_back({{0, 0}, {1, 0, 1}});
  for (vertex_index i = 0; i < n; ++i) {
    const vertex_index j = (i + 1) % n;
    m.triangles.insert(m.triangles.end(), {{i, j, 2 * n}, {i, n + i, n + j}, {i, n + j, j}});
    m.boundary.push_back({n + i, n + j, i, 7, false});
    m.boundary.push_back({i, j, n + i, 3, true});
  }
  for (vertex_index i = 0; i < n; ++i) m.regions.insert(m.regions.end(), {2, 1, 1});
  const mesh_outline kept = outline(m);
  CHECK(kept.boundary_vertices == 2 * n);
  CHECK(kept.kept > n);
  CHECK(kept.kept < 2 * n);
  for (vertex_index i = 0; i < n; ++i)
    CHECK(std::count(kept.shape.vertices.begin(), kept.shape.vertices.end(), m.sites[i].position) ==
          1);
  CHECK(enclosed_sizes(kept.shape).at(2) ==
        Approx(n / 2.0 * 0.25 * std::sin(2 * std::numbers::pi / n)));
  m.regions.clear();
  CHECK(outline(m).kept < kept.kept);
}
