// SPDX-License-Identifier: MIT
//
// Internal segments that meet at small angles. The mesh is certified with exempt angles listed.
// It is not complete, and has few sites, if other angles beside them cannot be improved.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/audit_meshes.hpp"
#include "fixtures/judged_mesh.hpp"
#include "fixtures/star_fixture.hpp"

using namespace asterism;
using namespace asterism::testing;
using asterism::vertex_index;

namespace {

// The square of side 2 around `centre`, its corners the first four vertices.
domain square_around(const point& centre) {
  domain d = square();
  for (point& q : d.vertices) q = {q.x + centre.x, q.y + centre.y};
  return d;
}

void add_segment(domain& d, vertex_index a, vertex_index b) {
  d.segments.push_back({a, b, 5, true});
}

vertex_index add_vertex(domain& d, const point& q) {
  d.vertices.push_back(q);
  return static_cast<vertex_index>(d.vertices.size() - 1);
}

// Returns segments that leave the centre at steps of `degrees`, each `shrink` times as long as the
// one before.
domain fan(int count, double degrees, double shrink = 1, const point& centre = {0, 0}) {
  domain d = square_around(centre);
  const vertex_index apex = add_vertex(d, centre);
  double length = 0.6;
  for (int k = 0; k < count; ++k, length *= shrink) {
    const double turn = (17 + degrees * k) * std::numbers::pi / 180;
    add_segment(
        d, apex,
        add_vertex(d, {centre.x + length * std::cos(turn), centre.y + length * std::sin(turn)}));
  }
  return d;
}

// Three segments around a sliver, sharp at both ends of the longest.
domain needle(double degrees) {
  domain d = square_around({0, 0});
  const vertex_index a = add_vertex(d, {-0.6, 0.1}), b = add_vertex(d, {0.6, 0.13});
  const double height = 0.6 * std::tan(degrees * std::numbers::pi / 180);
  const vertex_index c = add_vertex(d, {0.05, 0.115 + height});
  add_segment(d, a, b);
  add_segment(d, b, c);
  add_segment(d, c, a);
  return d;
}

// A segment from a corner of the square, close to one of its sides.
domain beside_a_side(double degrees) {
  domain d = square_around({0, 0});
  const double turn = degrees * std::numbers::pi / 180;
  add_segment(d, 0, add_vertex(d, {-1 + 0.9 * std::cos(turn), -1 + 0.9 * std::sin(turn)}));
  return d;
}

mesh_options wanted(bool limit_size) {
  mesh_options options;
  options.angle_bound = 20;
  options.limit_size = limit_size;
  options.strategy = refinement_strategy::fill;
  options.max_sites = 4000;
  return options;
}

std::size_t count_of(const audit_report& report, finding_kind kind) {
  return report.found[static_cast<std::size_t>(kind)];
}

// Checks that mesher and auditor agree: either all demands are met, or collateral angles are below
// the bound, equally many, and nothing else. Returns whether all demands are met.
bool check_agreement(const domain& d, const metric_field& field, bool limit_size,
                     std::size_t most_sites) {
  const mesh_outcome made = mesh_of(d, field, wanted(limit_size));
  INFO(ending_text(made));
  const audit_report report = audited(d, made, wanted(limit_size));
  for (const audit_finding& f : report.findings) UNSCOPED_INFO(f.witness);
  CHECK(made.complete == report.certified);
  CHECK(made.how() == (made.complete ? ending::complete : ending::collateral));
  CHECK(report.total_found() == count_of(report, finding_kind::collateral_angle_below_bound));
  CHECK(report.low_triangles.empty());
  CHECK(made.sites <= most_sites);
  CHECK_FALSE(made.exempt.empty());
  CHECK(report.exempt_triangles.size() == made.exempt_triangles.size());
  if (!made.complete)
    CHECK_THAT(ending_text(made),
               Catch::Contains(std::to_string(report.collateral_triangles.size()) + " triangles") &&
                   Catch::Contains("sharpest corner"));
  return made.complete;
}

// A square of side 2 with a wedge of 5.7 degrees that opens from its middle to the right. The
// wedge's segments are divided once, in their middle.
mesh divided_wedge() {
  mesh m = test::make_mesh_of({{0, 0},
                               {1, 0.05},
                               {1, -0.05},
                               {1, 1},
                               {-1, 1},
                               {-1, -1},
                               {1, -1},
                               {0.5, 0.025},
                               {0.5, -0.025}},
                              {{0, 8, 7},
                               {8, 2, 1},
                               {8, 1, 7},
                               {0, 7, 4},
                               {7, 1, 3},
                               {7, 3, 4},
                               {0, 4, 5},
                               {0, 5, 8},
                               {8, 5, 6},
                               {8, 6, 2}});
  m.given = 7;
  for (const auto& [a, b] : std::vector<std::pair<vertex_index, vertex_index>>{{0, 7}, {7, 1}})
    m.boundary.push_back({a, b, 20, 5, true});
  for (const auto& [a, b] : std::vector<std::pair<vertex_index, vertex_index>>{{0, 8}, {8, 2}})
    m.boundary.push_back({a, b, 21, 5, true});
  return m;
}

audit_report exempt_in(const mesh& m, double bound) {
  audit_options options;
  options.angle_bound = bound;
  options.find_exempt_corners = true;
  return audit(m, options);
}

bool is_collateral(const audit_report& report, vertex_index t) {
  return std::binary_search(report.collateral_triangles.begin(), report.collateral_triangles.end(),
                            t);
}

}  // namespace

TEST_CASE("internal wedges of a twentieth to five degrees cascaded to the tolerance") {
  const formula_field any = identity_field(), fifth = constant_field({25, 0, 25});
  for (const double degrees : {0.05, 0.1, 0.5, 1.0, 2.0, 5.0})
    for (const bool limit_size : {false, true}) {
      INFO(degrees << " degrees" << (limit_size ? ", with a size" : ""));
      const formula_field& field = limit_size ? fifth : any;
      check_agreement(fan(2, degrees), field, limit_size, 600);
      check_agreement(fan(3, degrees, 0.77), field, limit_size, 600);
      check_agreement(fan(5, degrees), field, limit_size, 900);
      check_agreement(needle(degrees), field, limit_size, 900);
      check_agreement(beside_a_side(degrees), field, limit_size, 900);
    }
}

TEST_CASE(
    "triangles across wedges of five to nine degrees were left low in a mesh called complete") {
  const formula_field any = identity_field(), fifth = constant_field({25, 0, 25});
  for (const bool limit_size : {false, true}) {
    const formula_field& field = limit_size ? fifth : any;
    for (const double degrees : {5.0, 7.0, 9.0}) {
      INFO(degrees << " degrees" << (limit_size ? ", with a size" : ""));
      CHECK(check_agreement(fan(2, degrees), field, limit_size, 600));
      CHECK(check_agreement(fan(3, degrees, 0.77), field, limit_size, 600));
      CHECK(check_agreement(fan(5, degrees), field, limit_size, 600));
      CHECK(check_agreement(needle(degrees), field, limit_size, 600));
      CHECK(check_agreement(beside_a_side(degrees), field, limit_size, 600));
    }
  }
}

TEST_CASE("wedges where the metric turns, and far from the origin") {
  for (const double degrees : {0.5, 2.0}) {
    INFO(degrees << " degrees");
    check_agreement(fan(2, degrees), swirl_field(12), false, 600);
    check_agreement(needle(degrees), swirl_field(12), false, 1500);
    check_agreement(fan(2, degrees, 1, {1e8, 1e8}), identity_field(), false, 600);
  }
}

TEST_CASE("a wedge as wide as half the bound exempts the triangle at its tip alone") {
  const domain d = fan(2, 11);
  const auto made = make_mesh(d, identity_field(), wanted(false));
  REQUIRE(made.ok());
  CHECK(made.value().complete);
  for (const triangle& t : made.value().exempt_triangles)
    CHECK(std::find(t.begin(), t.end(), vertex_index{4}) != t.end());
  CHECK(audited(d, made.value(), wanted(false)).certified);
}

TEST_CASE("triangles across an internal wedge were exempt, and are collateral") {
  const mesh m = divided_wedge();
  const audit_report report = exempt_in(m, 20);
  CHECK(report.exempt_corners == std::vector<vertex_index>{0});
  CHECK(report.exempt_triangles == std::vector<vertex_index>{0});  // at the tip
  CHECK_FALSE(is_collateral(report, 0));
  CHECK(is_collateral(report, 1));
  CHECK(is_collateral(report, 2));
  CHECK(count_of(report, finding_kind::collateral_angle_below_bound) > 0);
  CHECK_FALSE(report.low_triangles.empty());  // between the segments and the far corners
}

TEST_CASE("triangles across a wedge wider than half the bound are not exempt") {
  const audit_report report = exempt_in(divided_wedge(), 11);
  CHECK(report.exempt_corners == std::vector<vertex_index>{0});
  CHECK(report.exempt_triangles == std::vector<vertex_index>{0});
}

TEST_CASE("triangles across a wedge that one of their vertices measures wide are plainly low") {
  mesh m = divided_wedge();
  m.sites[1].metric = {1, 0, 25};  // 26 degrees
  const audit_report report = exempt_in(m, 20);
  CHECK(report.exempt_triangles == std::vector<vertex_index>{0});
  CHECK_FALSE(is_collateral(report, 1));
  CHECK_FALSE(is_collateral(report, 2));
}

TEST_CASE("a wedge between two segments of the rim exempts the triangle at its tip alone") {
  mesh m = test::make_mesh_of({{0, 0}, {1, -0.05}, {1, 0.05}, {0.5, -0.025}, {0.5, 0.025}},
                              {{0, 3, 4}, {3, 1, 2}, {3, 2, 4}});
  m.given = 3;
  const audit_report report = exempt_in(m, 20);
  CHECK(report.exempt_triangles == std::vector<vertex_index>{0});
  CHECK(report.low_triangles.size() == 2);
}

TEST_CASE("where a wedge keeps triangles below the bound the reason names its corner") {
  mesh_options few = wanted(false);
  few.tolerance = 0.4;  // too coarse for any site
  const auto made = make_mesh(fan(2, 14), identity_field(), few);
  REQUIRE(made.ok());
  CHECK_FALSE(made.value().complete);
  CHECK_THAT(ending_text(made.value()), Catch::Contains("vertex 5 at (0, 0), 14 degrees"));
}
