// SPDX-License-Identifier: MIT
//
// The auditor on internal edges, isolated points and regions: it passes right ones and finds those
// that are lost or moved.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <utility>

#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::test;
using asterism::vertex_index;

namespace {

// The patch with the diagonal from corner 1 to corner 3 as an internal segment of marker 20. Region
// 1 is on its left, where corner 0 is, and region 2 on its right.
patch divided_patch() {
  patch p = make_patch(4, 0);
  for (int k = 0; k < 4; ++k)
    p.m.boundary.push_back({p.at(4 - k, k), p.at(3 - k, k + 1), 4, 20, true});
  p.d.segments.push_back({1, 3, 20, true, 1, 2});
  p.d.segments[1].left_region = p.d.segments[2].left_region = 2;
  for (const triangle& t : p.m.triangles) {
    const auto is_upper = [&](vertex_index v) {
      const point& q = p.m.sites[v].position;
      return q.x + q.y / 1.75 > 4;
    };
    p.m.regions.push_back(std::any_of(t.begin(), t.end(), is_upper) ? 2 : 1);
  }
  return p;
}

void exchange(mesh& m, vertex_index i, vertex_index j) {
  const auto renamed = [&](vertex_index v) { return v == i ? j : v == j ? i : v; };
  std::swap(m.sites[i], m.sites[j]);
  for (triangle& t : m.triangles)
    for (vertex_index& v : t) v = renamed(v);
  for (boundary_edge& e : m.boundary) {
    e.a = renamed(e.a);
    e.b = renamed(e.b);
  }
}

// The diagonal from corner 1 to the middle of the patch alone: vertex 4 is its free end.
patch slit_patch() {
  patch p = make_patch(4, 0);
  const vertex_index middle = p.at(2, 2);
  for (int k = 0; k < 2; ++k)
    p.m.boundary.push_back({p.at(4 - k, k), p.at(3 - k, k + 1), 4, 20, true});
  p.d.segments.push_back({1, 4, 20, true});
  p.d.vertices.push_back(p.m.sites[middle].position);
  exchange(p.m, 4, middle);
  p.m.given = 5;
  return p;
}

audit_report audited(const patch& p) {
  audit_options options;
  options.angle_bound = 40;
  options.original = &p.d;
  return audit(p.m, options);
}

std::size_t internal_subsegment(const patch& p, std::size_t which) {
  for (std::size_t i = 0; i < p.m.boundary.size(); ++i)
    if (p.m.boundary[i].internal && which-- == 0) return i;
  return p.m.boundary.size();
}

}  // namespace

TEST_CASE("meshes with internal edges are certified") {
  for (const patch& p : {divided_patch(), slit_patch(), stretched(slit_patch(), 0x1p40)}) {
    const audit_report report = audited(p);
    INFO(kinds(report));
    CHECK(report.certified);
    CHECK(report.stars_checked);
  }
}

TEST_CASE("a lost internal edge is found") {
  for (patch p : {divided_patch(), slit_patch()}) {
    p.m.boundary.erase(p.m.boundary.begin() +
                       static_cast<std::ptrdiff_t>(internal_subsegment(p, 1)));
    const audit_report report = audited(p);
    CHECK_FALSE(report.certified);
    CHECK(found(report, finding_kind::segment_not_covered));
  }
}

TEST_CASE("an internal edge that is no edge of the triangles is found") {
  // The square is cut by the other diagonal, so that this one is no edge of a triangle.
  mesh m = make_mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  m.boundary.push_back({1, 3, 4, 0, true});
  CHECK(found(audit(m, {}), finding_kind::boundary_without_triangle));
  m.boundary.back() = {0, 2, 4, 0, true};
  CHECK_FALSE(found(audit(m, {}), finding_kind::boundary_without_triangle));
}

TEST_CASE("an internal edge with a triangle on one side alone is found") {
  mesh m = make_mesh_of({{0, 0}, {1, 0}, {0.5, 1}}, {{0, 1, 2}});
  m.boundary[1].internal = true;
  const audit_report report = audit(m, {});
  CHECK(witnesses(report, finding_kind::boundary_without_triangle).find("on its right") !=
        std::string::npos);
}

TEST_CASE("an edge said to be internal whose segment is not, and the reverse, are found") {
  patch p = divided_patch();
  p.d.segments[4].internal = false;
  CHECK(found(audited(p), finding_kind::side_changed));
  p = divided_patch();
  p.m.boundary[internal_subsegment(p, 0)].internal = false;
  const audit_report report = audited(p);
  CHECK(found(report, finding_kind::side_changed));
  CHECK(found(report, finding_kind::boundary_inside));
}

TEST_CASE("an internal edge named twice, in either direction, is found") {
  for (const bool turned : {false, true}) {
    patch p = divided_patch();
    boundary_edge again = p.m.boundary[internal_subsegment(p, 2)];
    if (turned) std::swap(again.a, again.b);
    p.m.boundary.push_back(again);
    CHECK(found(audited(p), finding_kind::repeated_boundary));
  }
}

TEST_CASE("a changed marker of an internal edge is found") {
  patch p = divided_patch();
  p.m.boundary[internal_subsegment(p, 1)].marker = 21;
  CHECK(found(audited(p), finding_kind::marker_changed));
}

TEST_CASE("an internal vertex off its segment is found") {
  patch p = divided_patch();
  p.m.sites[p.m.boundary[internal_subsegment(p, 0)].b].position.x += 0x1p-30;
  CHECK(found(audited(p), finding_kind::boundary_deviation));
}

TEST_CASE("an isolated point that is no vertex of the mesh is found") {
  mesh m = make_mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  for (vertex_index i = 0; i < 4; ++i) m.boundary[i].segment = i;
  domain d;
  for (const site& s : m.sites) d.vertices.push_back(s.position);
  for (const boundary_edge& e : m.boundary) d.segments.push_back({e.a, e.b});
  for (vertex_index i = 0; i < 4; ++i) m.boundary[i].segment = i;
  d.vertices.push_back({0.25, 0.5});
  audit_options options;
  options.original = &d;
  CHECK(found(audit(m, options), finding_kind::given_changed));
  m.sites.push_back({{0.25, 0.5}, round_metric});  // a vertex of the mesh, but of no triangle
  m.given = 5;
  const audit_report report = audit(m, options);
  CHECK_FALSE(found(report, finding_kind::given_changed));
  CHECK(found(report, finding_kind::unused_vertex));
}

TEST_CASE("a triangle with the number of another region is found") {
  patch p = divided_patch();
  p.m.regions[3] = 5;
  CHECK(found(audited(p), finding_kind::wrong_region));
  CHECK(found(audit(p.m, {}), finding_kind::wrong_region));  // found by its neighbours
  p = divided_patch();
  for (int& region : p.m.regions) region = 3 - region;  // exchanged everywhere: found by the domain
  CHECK(found(audited(p), finding_kind::wrong_region));
  CHECK_FALSE(found(audit(p.m, {}), finding_kind::wrong_region));
  p.m.regions.clear();
  CHECK(found(audited(p), finding_kind::wrong_region));
  p.m.regions = {1, 2};
  CHECK(witnesses(audited(p), finding_kind::wrong_region) ==
        "2 regions are given for 32 triangles\n");
}

TEST_CASE("the narrow angle between internal segments is an exempt corner, proven") {
  // Two internal segments from the middle of a square's lower side, 11 degrees apart.
  mesh m = make_mesh_of({{-1, 0}, {0, 0}, {1, 0}, {1, 1}, {0.1, 1}, {-0.1, 1}, {-1, 1}},
                        {{0, 1, 6}, {1, 5, 6}, {1, 4, 5}, {1, 3, 4}, {1, 2, 3}});
  audit_options options;
  options.angle_bound = 20;
  options.find_exempt_corners = true;
  options.check_stars = false;
  CHECK(found(audit(m, options), finding_kind::angle_below_bound));
  m.boundary.push_back({1, 4, 7, 0, true});
  m.boundary.push_back({5, 1, 8, 0, true});
  const audit_report report = audit(m, options);
  INFO(kinds(report));
  CHECK(report.certified);
  CHECK(report.exempt_corners == std::vector<vertex_index>{1});
}
