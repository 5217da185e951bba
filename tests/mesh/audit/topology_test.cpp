// SPDX-License-Identifier: MIT
//
// Points 0 to 2 of the auditor: valid meshes pass, and each kind of damage is named.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::test;
using Catch::Contains;

namespace {

audit_report run(const mesh& m, const domain* d = nullptr) {
  audit_options options;
  options.angle_bound = 20;
  options.original = d;
  return audit(m, options);
}

void refused(const mesh& m, finding_kind kind, const std::string& witness,
             const domain* d = nullptr) {
  const audit_report report = run(m, d);
  CAPTURE(kinds(report));
  CHECK_FALSE(report.certified);
  CHECK(found(report, kind));
  CHECK_THAT(witnesses(report, kind), Contains(witness));
}

}  // namespace

TEST_CASE("a sound mesh is certified with its domain") {
  const patch p = make_patch(8);
  const audit_report report = run(p.m, &p.d);
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.findings.empty());
  CHECK(report.triangles == 128);
  CHECK(report.boundary_subsegments == 32);
  CHECK(report.domain_checked);
  CHECK(report.angles_checked);
  CHECK(report.stars_checked);
  CHECK(report.largest_deviation == 0);
  CHECK(report.worst().degrees > 45);
  CHECK(report.worst().degrees < 60);
}

TEST_CASE("magnitudes far from one are certified too") {
  for (const double scale : {0x1p-400, 0x1p400}) {
    patch p = make_patch(3);
    for (site& s : p.m.sites) {
      s.position = {s.position.x * scale, s.position.y * scale};
      s.metric = {1 / scale, 0, 1 / scale};
    }
    for (point& q : p.d.vertices) q = {q.x * scale, q.y * scale};
    const audit_report report = run(p.m, &p.d);
    INFO(kinds(report));
    CHECK(report.certified);
  }
}

TEST_CASE("one index altered") {
  patch p = make_patch(4);
  p.m.triangles[5][1] = p.at(4, 4);
  const audit_report report = run(p.m);
  CHECK_FALSE(report.certified);
  CHECK(found(report, finding_kind::unmatched_edge));
  CHECK_THAT(witnesses(report, finding_kind::unmatched_edge), Contains("triangle 6 of"));
}

TEST_CASE("an index out of range, of a triangle and of a boundary edge") {
  patch p = make_patch(2);
  p.m.triangles[0][2] = 9;
  p.m.boundary[1].b = 4000000000U;
  const audit_report report = run(p.m);
  const std::string text = witnesses(report, finding_kind::index_out_of_range);
  CHECK_THAT(text, Contains("triangle 1 names vertex 10 of 9"));
  CHECK_THAT(text, Contains("boundary edge 2 names vertex 4000000001 of 9"));
}

TEST_CASE("one vertex moved across an edge") {
  patch p = make_patch(4);
  p.m.sites[p.at(2, 2)].position = {4.6, 1.75};
  refused(p.m, finding_kind::orientation, "(4.6, 1.75)");
}

TEST_CASE("a flat triangle") {
  const mesh m = make_mesh_of({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}});
  refused(m, finding_kind::orientation, "is flat");
}

TEST_CASE("one triangle removed") {
  patch p = make_patch(4);
  p.m.triangles.erase(p.m.triangles.begin() + 13);
  refused(p.m, finding_kind::unmatched_edge, "has no triangle across and is no boundary edge");
}

TEST_CASE("a triangle at the boundary removed") {
  patch p = make_patch(4);
  p.m.triangles.erase(p.m.triangles.begin());
  refused(p.m, finding_kind::boundary_without_triangle, "boundary edge 1 from vertex 1 (0, 0)");
}

TEST_CASE("one triangle doubled") {
  patch p = make_patch(4);
  p.m.triangles.push_back(p.m.triangles[9]);
  refused(p.m, finding_kind::repeated_triangle, "triangle 33 of");
  refused(p.m, finding_kind::repeated_edge, "runs the same way in triangle 10");
}

TEST_CASE("one triangle doubled under a rotation of its corners") {
  patch p = make_patch(4);
  const triangle t = p.m.triangles[9];
  p.m.triangles.push_back({t[1], t[2], t[0]});
  refused(p.m, finding_kind::repeated_triangle, "has the vertices of triangle 10");
}

TEST_CASE("one triangle turned over") {
  patch p = make_patch(4);
  std::swap(p.m.triangles[9][0], p.m.triangles[9][1]);
  refused(p.m, finding_kind::orientation, "triangle 10 of");
  refused(p.m, finding_kind::repeated_edge, "triangle 10");
}

TEST_CASE("a corner named twice") {
  patch p = make_patch(4);
  p.m.triangles[9][0] = p.m.triangles[9][1];
  refused(p.m, finding_kind::repeated_corner, "triangle 10 names vertex");
}

TEST_CASE("one metric made indefinite, semidefinite or not finite") {
  patch p = make_patch(4);
  p.m.sites[7].metric = {1, 2, 1};
  refused(p.m, finding_kind::metric_not_positive_definite, "the metric tensor 1 2 1 of vertex 8 (");
  p.m.sites[7].metric = {1, 1, 1};
  refused(p.m, finding_kind::metric_not_positive_definite, "vertex 8");
  p.m.sites[7].metric = {1, 0, std::numeric_limits<double>::infinity()};
  refused(p.m, finding_kind::not_finite, "the metric tensor 1 0 too large of vertex 8");
}

TEST_CASE("a coordinate that is not a number") {
  patch p = make_patch(4);
  p.m.sites[7].position.x = std::nan("");
  refused(p.m, finding_kind::not_finite, "vertex 8 (nan");
}

TEST_CASE("two vertices at one point") {
  patch p = make_patch(4);
  p.m.sites.push_back(p.m.sites[11]);
  refused(p.m, finding_kind::repeated_position, "vertex 12 (");
  refused(p.m, finding_kind::unused_vertex, "vertex 26 (");
}

TEST_CASE("a boundary edge removed, doubled, reversed") {
  const patch sound = make_patch(4);
  patch p = sound;
  p.m.boundary.erase(p.m.boundary.begin() + 4);
  refused(p.m, finding_kind::unmatched_edge, "is no boundary edge");
  refused(p.m, finding_kind::open_boundary, "more boundary edges");
  p = sound;
  p.m.boundary.push_back(p.m.boundary[4]);
  refused(p.m, finding_kind::repeated_boundary, "boundary edge 17 from");
  p = sound;
  std::swap(p.m.boundary[4].a, p.m.boundary[4].b);
  refused(p.m, finding_kind::boundary_without_triangle, "boundary edge 5 from");
  refused(p.m, finding_kind::boundary_inside, "boundary edge 5 from");
}

TEST_CASE("an inner edge passed off as boundary") {
  patch p = make_patch(4);
  p.m.boundary.push_back({p.at(1, 1), p.at(2, 1), 0, 0});
  p.m.boundary.push_back({p.at(2, 1), p.at(1, 1), 0, 0});
  refused(p.m, finding_kind::boundary_inside, "on its right");
}

TEST_CASE("boundaries that cross or touch") {
  SECTION("crossing") {
    const mesh m =
        make_mesh_of({{0, 0}, {4, 0}, {0, 4}, {1, 1}, {5, 1}, {1, 5}}, {{0, 1, 2}, {3, 4, 5}});
    refused(m, finding_kind::boundary_contact, "crosses or touches");
  }
  SECTION("a vertex on an edge") {
    const mesh m =
        make_mesh_of({{0, 0}, {4, 0}, {0, 4}, {2, 2}, {5, 2}, {3, 5}}, {{0, 1, 2}, {3, 4, 5}});
    refused(m, finding_kind::boundary_contact, "(2, 2)");
  }
  SECTION("overlapping on one line") {
    const mesh m =
        make_mesh_of({{0, 0}, {4, 0}, {0, 4}, {3, 0}, {1, 0}, {2, -1}}, {{0, 1, 2}, {3, 4, 5}});
    refused(m, finding_kind::boundary_contact, "crosses or touches");
  }
  SECTION("one common end is fine") {
    const mesh m = make_mesh_of({{0, 0}, {2, 0}, {1, 2}, {3, 2}, {2, 4}}, {{0, 1, 2}, {2, 3, 4}});
    const audit_report report = run(m);
    INFO(kinds(report));
    CHECK(report.certified);
  }
}

TEST_CASE("covered twice though every edge matches and no boundary touches") {
  const patch outer = make_patch(6);
  mesh m = outer.m;
  const auto first = static_cast<vertex_index>(m.sites.size());
  for (const point q : {point{4.1, 2.3}, point{4.7, 2.3}, point{4.4, 2.8}})
    m.sites.push_back({q, round_metric});
  m.triangles.push_back({first, first + 1, first + 2});
  for (vertex_index i = 0; i < 3; ++i) m.boundary.push_back({first + i, first + (i + 1) % 3, 0, 0});
  refused(m, finding_kind::wrong_winding, "winds 2 times instead of once");
}

TEST_CASE("a mesh wound twice around a vertex") {
  std::vector<point> points = {{0, 0}};
  std::vector<triangle> triangles;
  const vertex_index around = 10;
  for (vertex_index i = 0; i < around; ++i) {
    const double angle = 4 * 3.14159265358979 * i / around, radius = 1 + 0.05 * i;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    triangles.push_back({0, 1 + i, 1 + (i + 1) % around});
  }
  const mesh m = make_mesh_of(points, triangles);
  refused(m, finding_kind::boundary_contact, "crosses or touches");
}

TEST_CASE("a hole that the domain does not have") {
  const patch p = make_patch(4);
  mesh m = p.m;
  const triangle t = m.triangles[13];
  m.triangles.erase(m.triangles.begin() + 13);
  for (std::size_t i = 0; i < 3; ++i) m.boundary.push_back({t[(i + 1) % 3], t[i], 0, 0});
  CHECK(run(m).certified);  // valid as a mesh of some domain
  refused(m, finding_kind::segment_not_covered, "of them between given vertices", &p.d);
}

TEST_CASE("a hole, wound the right way, is part of the domain") {
  const patch outer = make_patch(6, 0);
  mesh m = outer.m;
  // Removes the six triangles around one vertex.
  const vertex_index centre = outer.at(3, 3);
  std::erase_if(m.triangles, [&](const triangle& t) {
    return t[0] == centre || t[1] == centre || t[2] == centre;
  });
  m.sites[centre] = m.sites.back();  // keep numbering dense: the last site takes its place
  for (triangle& t : m.triangles)
    for (vertex_index& v : t)
      if (v == m.sites.size() - 1) v = centre;
  m.sites.pop_back();
  std::vector<point> points;
  for (const site& s : m.sites) points.push_back(s.position);
  const mesh with_hole = make_mesh_of(points, m.triangles);
  const audit_report report = run(with_hole);
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.boundary_subsegments == 24 + 6);
}

TEST_CASE("against the domain: vertices, segments, markers, deviation") {
  const patch p = make_patch(4);
  SECTION("a given vertex moved by one unit in the last place") {
    domain d = p.d;
    d.vertices[1].x = std::nextafter(d.vertices[1].x, 9);
    refused(p.m, finding_kind::given_changed, "vertex 2 (4, 0) was given at (4.000000000000001, 0)",
            &d);
  }
  SECTION("a domain vertex missing") {
    domain d = p.d;
    d.vertices.push_back({2, 1});
    refused(p.m, finding_kind::given_changed, "4 vertices are kept as given, the domain has 5", &d);
  }
  SECTION("another segment") {
    domain d = p.d;
    d.segments[2] = {2, 1, 12};
    refused(p.m, finding_kind::segment_not_covered, "segment 3 from vertex 3", &d);
  }
  SECTION("another marker") {
    mesh m = p.m;
    m.boundary[3].marker = 77;
    refused(m, finding_kind::marker_changed, "has marker 77, its segment has 13", &p.d);
  }
  SECTION("a split point off its segment by rounding is reported") {
    mesh m = p.m;
    m.sites[p.at(4, 2)].position.x = std::nextafter(m.sites[p.at(4, 2)].position.x, 9);
    const audit_report report = run(m, &p.d);
    INFO(kinds(report));
    CHECK(report.certified);
    CHECK(report.largest_deviation > 0);
    CHECK(report.largest_deviation < 1e-15);
  }
  SECTION("and by more than rounding is refused") {
    mesh m = p.m;
    m.sites[p.at(4, 2)].position.x += 1e-6;
    refused(m, finding_kind::boundary_deviation, "away from the segment from vertex 2", &p.d);
  }
  SECTION("by forty units in the last place, where it was thousands") {
    mesh m = p.m;
    m.sites[p.at(4, 2)].position.x += 40 * 0x1p-50;
    refused(m, finding_kind::boundary_deviation, "units in the last place, away from the segment",
            &p.d);
  }
  SECTION("split points out of order") {
    mesh m = p.m;
    std::swap(m.sites[p.at(1, 0)].position, m.sites[p.at(2, 0)].position);
    refused(m, finding_kind::segment_not_covered, "runs against its segment", &p.d);
  }
}

TEST_CASE("a roof in the place of a side was within the limit on deviation") {
  // A square with sides of 64 units in the last place, far from the origin. Its lower side is a
  // roof of height 24 units.
  const double o = 0x1p30, ulp = 0x1p-22;
  mesh m = make_mesh_of({{o, o},
                         {o + 64 * ulp, o},
                         {o + 64 * ulp, o + 64 * ulp},
                         {o, o + 64 * ulp},
                         {o + 32 * ulp, o + 24 * ulp}},
                        {{0, 4, 3}, {4, 1, 2}, {3, 4, 2}});
  m.given = 4;
  domain d;
  for (int v = 0; v < 4; ++v) d.vertices.push_back(m.sites[static_cast<std::size_t>(v)].position);
  d.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  refused(m, finding_kind::boundary_deviation, "vertex 5", &d);
}

TEST_CASE("an empty mesh and one with disagreeing triangles are not certified") {
  refused({}, finding_kind::empty_mesh, "no triangle");
  patch p = make_patch(3);
  p.m.disagreeing.push_back(p.m.triangles[0]);
  refused(p.m, finding_kind::disagreeing_triangles, "1 triangles");
}

TEST_CASE("findings are capped and all counted") {
  patch p = make_patch(8);
  for (triangle& t : p.m.triangles) std::swap(t[0], t[1]);
  audit_options options;
  options.findings_kept = 3;
  const audit_report report = audit(p.m, options);
  CHECK(report.found[static_cast<std::size_t>(finding_kind::orientation)] == 128);
  CHECK(std::count_if(report.findings.begin(), report.findings.end(),
                      [](const auto& f) { return f.kind == finding_kind::orientation; }) == 3);
}
