// SPDX-License-Identifier: MIT
//
// Whole meshes of every kind of domain, certified by the auditor.
#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/mesher.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

void check_certified(const domain& d, const metric_field& field, const mesh_options& asked) {
  CHECK(make_and_check(d, field, asked).disagreeing == 0);
}

}  // namespace

TEST_CASE("every kind of domain is meshed at 20 degrees and certified, by arcs") {
  for (const named_domain& kind : domain_kinds()) {
    INFO(kind.name);
    check_certified(kind.shape, identity_field(), {});
  }
}

TEST_CASE("every kind of domain is meshed at 20 degrees and certified, by darts") {
  mesh_options options;
  options.strategy = refinement_strategy::poisson_darts;
  for (const named_domain& kind : domain_kinds()) {
    // Around corners of 8 degrees, inside or not, darts must be bounded.
    if (kind.name == "fan") continue;
    INFO(kind.name);
    check_certified(kind.shape, identity_field(), options);
  }
}

TEST_CASE("anisotropic metrics: the sides of an internal segment do not disagree") {
  for (const named_domain& kind : domain_kinds()) {
    if (kind.name == "fan") continue;
    INFO(kind.name);
    const point far = kind.shape.box().high;
    const formula_field swirl([far](const point& q) {
      const double x = q.x / far.x, y = q.y / far.y;
      return metric_tensor{1 + 3 * x * x, 3 * x * y, 1 + 3 * y * y};
    });
    mesh_options options;
    options.angle_bound = 15;
    check_certified(kind.shape, swirl, options);
  }
}

TEST_CASE("with a size limit both sides of every internal segment are refined") {
  mesh_options options;
  options.limit_size = true;
  check_certified(with_dangling_segments(), constant_field({64, 0, 64}), options);
  check_certified(divided(), constant_field({16, 4, 9}), options);
}

TEST_CASE("free ends an ulp from the boundary, and a domain far from the origin") {
  domain near = square();
  add_chain(near, {{0.5, 0}, {std::nextafter(1.0, 0.0), 0.25}});
  mesh_options options;
  options.max_sites = 400;
  const domain d = accepted(near);
  const auto made = make_mesh(d, identity_field(), options);
  REQUIRE(made.ok());  // complete or not
  domain far = with_fan();
  for (point& q : far.vertices) q = {q.x + 1e8, q.y - 1e8};
  check_certified(accepted(far), identity_field(), {});
  domain small = with_fan();
  for (point& q : small.vertices) q = {q.x * 0x1p-100, q.y * 0x1p-100};
  check_certified(accepted(small), constant_field({0x1p200, 0, 0x1p200}), {});
}

TEST_CASE("a sharp corner excuses nothing in the wide corner beside it") {
  // At (5, 5) there are 14 degrees above the chain's last segment and 76 below it. A triangle below
  // it is not exempt: if refinement called it so, the audit would refuse a mesh that refinement
  // calls complete.
  domain d = polygon(box_ring(0, 0, 5, 5));
  add_ring(d, {{3, 2}, {2, 2}, {2, 1}, {3, 1}});
  add_chain(d, {{1, 0}, {1, 4}, {1, 5}});
  add_chain(d, {{5, 5}, {1, 4}});
  d.vertices.push_back({5, 4});
  d.vertices.push_back({1, 1});
  mesh_options options;
  options.angle_bound = 15;
  check_certified(accepted(d), identity_field(), options);
}

TEST_CASE("a Voronoi vertex on a segment has it split, though nothing encroaches") {
  // The right angle at (3, 3) faces the subsegment from (3, 4) to (3.25, 3). Its circumcentre is
  // the subsegment's middle, neither inside nor encroaching. Refinement must split the subsegment
  // and not end there.
  domain d = polygon(box_ring(0, 0, 5, 5));
  add_chain(d, {{0, 5}, {2, 4}});
  add_chain(d, {{3, 4}, {4, 0}});
  for (const point& q : {point{3, 3}, {4, 5}, {3, 0}}) d.vertices.push_back(q);
  mesh_options options;
  options.angle_bound = 15;
  check_certified(accepted(d), identity_field(), options);
}

namespace {

// Corners of 11 and 31 degrees in a square of side 4, moved so far from the origin that `ulps`
// doubles lie between whole numbers.
domain sharp_corners_among_few_doubles(double ulps) {
  domain d = polygon(box_ring(0, 0, 4, 4));
  add_chain(d, {{3, 0}, {4, 4}, {3, 1}});
  for (point& q : d.vertices) q = {0x1p26 + q.x * 0x1p-26 * ulps, 0x1p26 + q.y * 0x1p-26 * ulps};
  return accepted(d);
}

}  // namespace

TEST_CASE("a point that splits a segment was rounded onto the next segment of its corner") {
  const auto made = make_mesh(sharp_corners_among_few_doubles(16), identity_field(), {});
  REQUIRE(made.ok());
  CHECK(made.value().disagreeing == 0);
  audit_options options;
  options.angle_bound = 0;
  const audit_report report = audit(made.value().result, options);
  for (const audit_finding& f : report.findings) UNSCOPED_INFO(f.witness);
  CHECK(report.certified);
}

TEST_CASE("shells around a sharp corner that rounding made unequal split each other down to ulps") {
  for (const double ulps : {64, 32}) {
    const domain d = sharp_corners_among_few_doubles(ulps);
    const mesh_outcome made = mesh_of(d, identity_field(), {});
    CHECK(made.sites < 100);
    const audit_report report = audited(d, made, {});
    // With so few doubles, no points may exist that give angles beside the corners.
    CHECK((made.complete || made.how() == ending::collateral));
    CHECK(made.complete == report.certified);
    CHECK(report.total_found() ==
          report.found[static_cast<std::size_t>(finding_kind::collateral_angle_below_bound)]);
  }
}
