// SPDX-License-Identifier: MIT
//
// Point 3 of the auditor: the angle bound to the last bit, perspectives, exempt corners.
#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::test;
using Catch::Contains;

namespace {

audit_report run(const mesh& m, double bound, std::vector<vertex_index> exempt = {}) {
  audit_options options;
  options.angle_bound = bound;
  options.exempt_corners = std::move(exempt);
  return audit(m, options);
}

// Returns atan(slope) in degrees, rounded to the double below or above.
double degrees_of(double slope, mpfr_rnd_t direction) {
  mpfr_t angle, pi;
  mpfr_init2(angle, 300);
  mpfr_init2(pi, 300);
  mpfr_set_d(angle, slope, MPFR_RNDN);
  mpfr_atan(angle, angle, MPFR_RNDN);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul_ui(angle, angle, 180, MPFR_RNDN);
  mpfr_div(angle, angle, pi, MPFR_RNDN);
  const double result = mpfr_get_d(angle, direction);
  mpfr_clear(pi);
  mpfr_clear(angle);
  return result;
}

mesh right_triangle(double slope) {
  return make_mesh_of({{0, 0}, {1, 0}, {1, slope}}, {{0, 1, 2}});
}

}  // namespace

TEST_CASE("an angle equal to the bound passes where its cotangent is rational") {
  const mesh half_square = right_triangle(1);
  CHECK(run(half_square, 45).certified);
  CHECK_FALSE(run(half_square, std::nextafter(45, 90)).certified);
  CHECK(run(half_square, std::nextafter(45, 0)).certified);
}

TEST_CASE("plain doubles settle an angle only the right way, and what is the least one") {
  const std::uint64_t seed = 33;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t decisions = 0, exact = 0;
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    const double scale = std::ldexp(1.0, i % 7 * 40 - 120), offset = i % 3 == 0 ? 1e6 : 0;
    mesh m = make_mesh_of({{(offset - 1 + random.real(0, 0.5)) * scale, 0},
                           {(offset + 1) * scale, random.real(-0.5, 0.5) * scale},
                           {(offset + random.real(-0.5, 0.5)) * scale, scale}},
                          {{0, 1, 2}});
    for (site& s : m.sites) {
      const double stretch = std::exp(random.real(0, 7)), tilt = random.real(-3, 3);
      s.metric = {stretch / scale, tilt / scale, (1 + tilt * tilt / stretch) / scale};
    }
    long double least = 180;
    for (const site& s : m.sites)
      for (std::size_t c = 0; c < 3; ++c) {
        const point &at = m.sites[c].position, &p = m.sites[(c + 1) % 3].position,
                    &q = m.sites[(c + 2) % 3].position;
        const long double ax = p.x - at.x, ay = p.y - at.y, bx = q.x - at.x, by = q.y - at.y;
        const long double det =
            1.0L * s.metric.m11 * s.metric.m22 - 1.0L * s.metric.m12 * s.metric.m12;
        const long double inner =
            s.metric.m11 * ax * bx + s.metric.m12 * (ax * by + ay * bx) + s.metric.m22 * ay * by;
        least = std::fmin(least, std::atan2(std::sqrt(det) * (ax * by - ay * bx), inner));
      }
    const double degrees = static_cast<double>(least * 180 / std::acos(-1.0L));
    const audit_report below = run(m, degrees * (1 - 1e-8)), above = run(m, degrees * (1 + 1e-8));
    CHECK(found(above, finding_kind::angle_below_bound));
    CHECK_FALSE(found(below, finding_kind::angle_below_bound));
    CHECK(below.worst().degrees == Approx(degrees).epsilon(1e-9));
    decisions += below.decisions;
    exact += below.exact_decisions;
  }
  CHECK(decisions == 10 * 400);  // and one each for the winding number
  CHECK(exact == 400);
}

TEST_CASE("one unit in the last place decides") {
  for (const double slope : {0.01, 0.2, 0.36397023426620234, 0.7, 0.99}) {
    const mesh m = right_triangle(slope);
    const double below = degrees_of(slope, MPFR_RNDD), above = degrees_of(slope, MPFR_RNDU);
    REQUIRE(std::nextafter(below, 90) == above);
    CHECK(run(m, below).certified);
    const audit_report report = run(m, above);
    CHECK_FALSE(report.certified);
    CHECK_THAT(witnesses(report, finding_kind::angle_below_bound),
               Contains("the angle at vertex 1 (0, 0) of triangle 1 of"));
    CHECK(report.worst().degrees == Approx(below));
    CHECK(report.worst().corner == 0);
  }
}

TEST_CASE("every vertex's metric is asked") {
  for (vertex_index v = 0; v < 3; ++v) {
    mesh m = make_mesh_of({{0, 0}, {1, 0}, {0.5, 0.875}}, {{0, 1, 2}});
    m.sites[v].metric = {1, 0, 1.0 / 64};  // in this metric the triangle is an eighth as high
    const audit_report report = run(m, 20);
    CHECK_FALSE(report.certified);
    CHECK(report.worst().perspective == v);
    CHECK_THAT(witnesses(report, finding_kind::angle_below_bound),
               Contains("in the metric of vertex " + std::to_string(v + 1)));
  }
}

TEST_CASE("a constant metric is a change of coordinates") {
  for (const double stretch : {0x1p-300, 0.001, 64.0, 0x1p200}) {
    const patch p = stretched(make_patch(4), stretch);
    const audit_report report = run(p.m, 45);
    INFO(kinds(report));
    CHECK(report.certified);
    CHECK(report.worst().degrees == Approx(run(make_patch(4).m, 45).worst().degrees));
  }
}

TEST_CASE("no bound, bound zero, bounds that are none") {
  const mesh sliver = right_triangle(1e-9);
  CHECK(audit(sliver, {}).certified);
  CHECK_FALSE(audit(sliver, {}).angles_checked);
  CHECK(run(sliver, 0).certified);
  CHECK(run(sliver, 1e-300).certified);
  for (const double bound : {-1.0, 90.0, std::nan("")})
    CHECK(found(run(sliver, bound), finding_kind::invalid_option));
}

TEST_CASE("an exempt corner is proven or refused") {
  const mesh m = right_triangle(0.2);  // 11.3 degrees at vertex 1, 78.7 at vertex 3
  CHECK_FALSE(run(m, 20).certified);

  const audit_report exempt = run(m, 20, {0});
  INFO(kinds(exempt));
  CHECK(exempt.certified);
  CHECK(exempt.exempt_corners == std::vector<vertex_index>{0});
  CHECK(exempt.exempt_triangles == std::vector<vertex_index>{0});
  CHECK(exempt.worst_exempt.degrees == Approx(11.3099).epsilon(1e-4));

  const audit_report wrong = run(m, 20, {2});
  CHECK(found(wrong, finding_kind::exemption_not_proven));
  CHECK(found(wrong, finding_kind::angle_below_bound));
  CHECK_THAT(witnesses(wrong, finding_kind::exemption_not_proven), Contains("vertex 3 (1, 0.2)"));
  CHECK(found(run(m, 20, {17}), finding_kind::exemption_not_proven));

  audit_options search;
  search.angle_bound = 20;
  search.find_exempt_corners = true;
  CHECK(audit(m, search).exempt_corners == std::vector<vertex_index>{0});
}

TEST_CASE("every angle of a triangle at a sharp corner was exempt") {
  // 19 degrees at vertex 1, and another angle of 0.3 at vertex 2.
  const double x = std::cos(19 * 3.14159265358979 / 180), y = std::sin(19 * 3.14159265358979 / 180);
  const mesh m =
      make_mesh_of({{0, 0}, {1, 0}, {0.01 * x, 0.01 * y}, {x, y}}, {{0, 1, 2}, {1, 3, 2}});
  const audit_report report = run(m, 20, {0});
  CHECK_FALSE(report.certified);
  CHECK(report.exempt_triangles == std::vector<vertex_index>{0});
  CHECK(report.collateral_triangles == std::vector<vertex_index>{0});
  CHECK(report.worst_exempt.degrees == Approx(19));
  CHECK(report.worst_collateral.degrees < 0.3);
  CHECK(report.worst().degrees == report.worst_collateral.degrees);
  CHECK_THAT(witnesses(report, finding_kind::collateral_angle_below_bound),
             Contains("the angle at vertex 2") && Contains("excuses its own angle alone"));
}

TEST_CASE("another metric has to measure the domain's corner below the bound as well") {
  mesh m = right_triangle(0.2);      // 11.3 degrees
  m.sites[1].metric = {1, 0, 0.25};  // the angle at vertex 1 is 5.7 degrees from here
  CHECK(run(m, 8, {}).found[static_cast<std::size_t>(finding_kind::angle_below_bound)] == 1);
  m.sites[0].metric = {1, 0, 0.25};  // and now in the corner's own metric
  const audit_report report = run(m, 8, {0});
  CHECK(report.certified);
  CHECK(report.worst_exempt.degrees == Approx(5.71).epsilon(1e-3));
  CHECK(report.worst_collateral.degrees == Approx(11.3099).epsilon(1e-4));
}

TEST_CASE("the corner's own metric decides its exemption") {
  mesh m = right_triangle(0.2);
  m.sites[0].metric = {1, 0, 25};  // measures 45 degrees
  const audit_report report = run(m, 20, {0});
  CHECK(found(report, finding_kind::exemption_not_proven));
  CHECK(found(report, finding_kind::angle_below_bound));  // the other two still measure 11
}

TEST_CASE("an inner vertex and a straight one are no corners") {
  const patch p = make_patch(4);
  for (const vertex_index v : {p.at(2, 2), p.at(2, 0), p.at(4, 0)})
    CHECK(found(run(p.m, 40, {v}), finding_kind::exemption_not_proven));
}

TEST_CASE("only triangles in the narrow sector of a corner are exempt") {
  // Two triangles meet at vertex 1. One has an angle of 11 degrees there, the other has one
  // elsewhere.
  const mesh m =
      make_mesh_of({{0, 0}, {1, 0}, {1, 0.2}, {-0.2, 1}, {-0.2, 0}}, {{0, 1, 2}, {0, 3, 4}});
  const audit_report report = run(m, 20, {0});
  CHECK(report.exempt_triangles == std::vector<vertex_index>{0});
  CHECK_THAT(witnesses(report, finding_kind::angle_below_bound), Contains("triangle 2 of"));
}
