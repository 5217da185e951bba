// SPDX-License-Identifier: MIT
//
// Curves of a domain against the boundary of a mesh: distances, and what is refused.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/domain/divide_curves.hpp"

using namespace asterism;

namespace {

// A regular polygon of a circle about the origin, and the fan of triangles from its centre.
struct disc {
  domain d;
  mesh m;

  explicit disc(double tolerance, double radius = 1) {
    domain whole;
    whole.vertices = {{radius, 0}};
    whole.segments = {{0, 0, 7}};
    domain_curve circle;
    circle.vertices = {0, 0};
    circle.parameters = {0, 1};
    whole.curves = {circle};
    curve_division wanted;
    wanted.chord_tolerance = tolerance;
    const auto divided = divide_curves(whole, wanted);
    REQUIRE(divided);
    d = check_domain(divided.value()).value();
    for (const point& p : d.vertices) m.sites.push_back({p, {1, 0, 1}});
    const auto centre = static_cast<vertex_index>(m.sites.size());
    m.sites.push_back({{0, 0}, {1, 0, 1}});
    m.given = centre;
    for (vertex_index s = 0; s < d.segments.size(); ++s) {
      m.triangles.push_back({d.segments[s].a, d.segments[s].b, centre});
      m.boundary.push_back({d.segments[s].a, d.segments[s].b, s, 7, false});
    }
  }

  audit_report audited() const {
    audit_options options;
    options.original = &d;
    return audit(m, options);
  }
};

bool found(const audit_report& report, finding_kind kind) {
  return report.found[static_cast<std::size_t>(kind)] > 0;
}

}  // namespace

TEST_CASE("the distance of a circle from its chords is bounded closely") {
  for (const double radius : {1.0, 0x1p-40, 3e7}) {
    const disc made(0.01 * radius, radius);
    const audit_report report = made.audited();
    CHECK(report.certified);
    const auto chords = static_cast<double>(made.d.segments.size());
    const double height = radius * (1 - std::cos(std::numbers::pi / chords));
    CHECK(report.curves.curves == 1);
    CHECK(report.curves.vertices == made.d.segments.size());
    CHECK(report.curves.largest_distance >= height * (1 - 1e-12));
    CHECK(report.curves.largest_distance <= height * (1 + 1e-9));
  }
}

TEST_CASE("a vertex of the domain off its curve is found") {
  disc made(0.01);
  made.d.curves[0].centre.x = 1e-12;
  CHECK(found(made.audited(), finding_kind::curve_deviation));
}

TEST_CASE("a curve that turns the other way is found") {
  disc made(0.01);
  made.d.curves[0].clockwise = true;
  CHECK(found(made.audited(), finding_kind::curve_deviation));
}

TEST_CASE("a curve that leaves out vertices, or has no segments, is found") {
  disc made(0.01);
  domain_curve& circle = made.d.curves[0];
  SECTION("a vertex left out") {
    circle.vertices.erase(circle.vertices.begin() + 2);
    circle.parameters.erase(circle.parameters.begin() + 2);
  }
  SECTION("parameters out of order") { std::swap(circle.parameters[1], circle.parameters[2]); }
  SECTION("a vertex out of range") { circle.vertices[1] = 1000; }
  SECTION("a number that is none") { circle.centre.y = std::nan(""); }
  SECTION("a radius of zero") { circle.centre = made.d.vertices[0]; }
  CHECK(found(made.audited(), finding_kind::curve_deviation));
}

TEST_CASE("a cubic is held against its control points") {
  domain whole;
  whole.vertices = {{0, 0}, {1, 0}, {0.5, -1}};
  whole.segments = {{0, 1}, {1, 2}, {2, 0}};
  domain_curve cubic;
  cubic.kind = curve_kind::cubic;
  cubic.control = {point{0.25, 0.5}, point{0.75, 0.5}};
  cubic.vertices = {0, 1};
  cubic.parameters = {0, 1};
  whole.curves = {cubic};
  const auto divided = divide_curves_at(whole, {{0, 0.5, 1}});
  REQUIRE(divided);
  const domain d = check_domain(divided.value()).value();
  mesh m;
  for (const point& p : d.vertices) m.sites.push_back({p, {1, 0, 1}});
  m.given = 4;
  m.triangles = {{0, 2, 1}, {0, 1, 3}};  // Delaunay
  for (vertex_index s = 0; s < d.segments.size(); ++s)
    m.boundary.push_back({d.segments[s].a, d.segments[s].b, s, 0, false});
  audit_options options;
  options.original = &d;
  const audit_report report = audit(m, options);
  CHECK(report.certified);
  // A half of the cubic has its control points (0, 0), (1/8, 1/4), (5/16, 3/8), (1/2, 3/8).
  const double length = std::hypot(0.5, 0.375);
  const double off = (0.5 * 0.25 - 0.375 * 0.125) / length;
  CHECK(report.curves.largest_distance >= 0.75 * off * (1 - 1e-12));
  CHECK(report.curves.largest_distance <= 0.75 * off * (1 + 1e-12));
}
