// SPDX-License-Identifier: MIT
//
// Metrics of formulas. Where a mesh exists for a metric it is met to the last bit; elsewhere the
// mesh is certified in a delivered metric, whose distance from the wanted one is reported.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "fixtures/domain_kinds.hpp"
#include "fixtures/judged_mesh.hpp"

using namespace asterism;
using namespace asterism::testing;

namespace {

mesh_options with_size(bool limit_size = true) {
  mesh_options options;
  options.limit_size = limit_size;
  return options;
}

// Squares stretched ten times, alternately along x and along y.
metric_tensor checkered(const point& q) {
  constexpr double side = 0.52, s = 1 / 0.64;
  const bool along = (std::lround(std::floor(q.x / side) + std::floor(q.y / side)) & 1) != 0;
  return along ? metric_tensor{100 * s, 0, s} : metric_tensor{s, 0, 100 * s};
}

mesh_outcome named(const std::string& name, double size) {
  const domain d = accepted(square());
  const auto field = make_metric_field(name, d.box(), size);
  REQUIRE(field.ok());
  return mesh_of(d, *field.value(), with_size());
}

void check_delivered(const domain& d, const mesh_outcome& made, const metric_field& wanted) {
  INFO(ending_text(made));
  CHECK(made.complete);
  CHECK(made.disagreeing == 0);
  CHECK_FALSE(made.one_metric);
  audit_options options;
  options.angle_bound = 20;
  options.find_exempt_corners = true;
  options.original = &d;
  const audit_report report = audit(made.result, options);
  for (const audit_finding& f : report.findings) UNSCOPED_INFO(f.witness);
  CHECK(report.certified);
  REQUIRE(made.delivered);
  const auto again = internal::compare_with_wanted(made.result, wanted, 20);
  REQUIRE(again.ok());
  CHECK(again.value().changed == made.delivered->changed);
  CHECK(again.value().greatest == made.delivered->greatest);
}

}  // namespace

TEST_CASE("a formula that meshes meet is met to the last bit") {
  for (const auto& [name, size] :
       {std::pair("swirl:12", 0.25), {"sink:60", 0.5}, {"layer:0.05,0.5", 1.0}, {"linear", 3.0}}) {
    const mesh_outcome made = named(name, size);
    INFO(name << ": " << ending_text(made));
    CHECK(made.complete);
    CHECK_FALSE(made.one_metric);
    CHECK_FALSE(made.delivered);
    const domain d = accepted(square());
    const auto field = make_metric_field(name, d.box(), size);
    for (const site& s : made.result.sites)
      CHECK(identical(s.metric, field.value()->at(s.position).value()));
  }
}

TEST_CASE("shock:50, which took half a minute and was not met") {
  const domain d = accepted(square());
  const auto field = make_metric_field("shock:50", d.box(), 0.3);
  const mesh_outcome made = mesh_of(d, *field.value(), with_size());
  check_delivered(d, made, *field.value());
  CHECK(made.delivered->changed > 0);
  CHECK(made.sites < 400);
}

TEST_CASE("perpendicular stretchings side by side, with a size and without") {
  const domain d = accepted(square());
  const formula_field field(checkered);
  for (const bool limit_size : {true, false})
    check_delivered(d, mesh_of(d, field, with_size(limit_size)), field);
}

TEST_CASE("a metric delivered is the same for any number of threads and at any scale") {
  const domain d = accepted(square());
  const mesh_outcome first = mesh_of(d, formula_field(checkered), with_size());
  {
    const internal::thread_limit one(1);
    const mesh_outcome again = mesh_of(d, formula_field(checkered), with_size());
    CHECK(mesh_fingerprint(again.result) == mesh_fingerprint(first.result));
    CHECK(ending_text(again) == ending_text(first));
  }
  for (const int exponent : {-400, 400}) {
    domain scaled = d;
    for (point& q : scaled.vertices) q = {std::ldexp(q.x, exponent), std::ldexp(q.y, exponent)};
    const formula_field field([exponent](const point& q) {
      const metric_tensor m = checkered({std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent)});
      return metric_tensor{std::ldexp(m.m11, -2 * exponent), std::ldexp(m.m12, -2 * exponent),
                           std::ldexp(m.m22, -2 * exponent)};
    });
    const mesh_outcome made = mesh_of(accepted(scaled), field, with_size());
    INFO(exponent << ": " << ending_text(made));
    CHECK(made.complete);
    REQUIRE(made.delivered);
    CHECK(made.delivered->greatest < 4);  // before, it was NaN
    CHECK(static_cast<double>(made.triangles) == Approx(first.triangles).epsilon(0.1));
  }
}

TEST_CASE("a metric delivered within a limit on sites has longer edges and is not complete") {
  const domain d = accepted(square());
  mesh_options options = with_size();
  options.max_sites = 150;
  const formula_field field([](const point& q) {
    const metric_tensor m = checkered(q);
    return metric_tensor{16 * m.m11, 16 * m.m12, 16 * m.m22};
  });
  const mesh_outcome made = mesh_of(d, field, options);
  INFO(ending_text(made));
  CHECK(made.sites <= 150);
  CHECK(made.disagreeing == 0);
  CHECK_FALSE(made.complete);
  CHECK(made.ended.length_factor > 1);
}

TEST_CASE("no metric is delivered where the one wanted is to be kept") {
  mesh_options options = with_size();
  options.metric_tolerance = 0;
  const mesh_outcome made = mesh_of(accepted(square()), formula_field(checkered), options);
  CHECK_FALSE(made.complete);
  CHECK_FALSE(made.delivered);
  CHECK(made.disagreeing > 0);
}

TEST_CASE("a metric tolerance is kept, or the distance found is told with status and reason") {
  const domain d = accepted(square());
  const formula_field field(checkered);
  mesh_options options = with_size();
  const mesh_outcome any = mesh_of(d, field, options);
  REQUIRE(any.complete);
  REQUIRE(any.delivered);
  const double distance = any.delivered->greatest;
  REQUIRE(distance > 0);

  options.metric_tolerance = distance;
  const mesh_outcome kept = mesh_of(d, field, options);
  CHECK(kept.complete);
  CHECK_FALSE(kept.intolerable);
  CHECK(mesh_fingerprint(kept.result) == mesh_fingerprint(any.result));

  options.metric_tolerance = distance / 2;
  const mesh_outcome beyond = mesh_of(d, field, options);
  CHECK_FALSE(beyond.complete);
  REQUIRE(beyond.intolerable);
  CHECK(beyond.intolerable->found > distance / 2);
  CHECK(beyond.how() == ending::intolerable);
  CHECK(ending_text(beyond).find("is tolerated; a metric tolerance of ") != std::string::npos);
}

TEST_CASE("a mesh in the metric wanted was refused for a tolerance larger than 0") {
  const domain d = accepted(square());
  const auto field = make_metric_field("shock:15", d.box(), 0.3);
  mesh_options options = with_size();
  options.metric_tolerance = 0;
  const mesh_outcome strict = mesh_of(d, *field.value(), options);
  REQUIRE(strict.complete);
  options.metric_tolerance = 0.1;
  const mesh_outcome tolerant = mesh_of(d, *field.value(), options);
  CHECK(tolerant.complete);
  CHECK_FALSE(tolerant.intolerable);
  CHECK(mesh_fingerprint(tolerant.result) == mesh_fingerprint(strict.result));
}

TEST_CASE("one metric for quarters stretched across each other passed for the one wanted") {
  const domain d = accepted(square());
  const formula_field field([](const point& q) {
    constexpr double s = 1.0 / 9;
    return (q.x > 0) == (q.y > 0) ? metric_tensor{1e6 * s, 0, s} : metric_tensor{s, 0, 1e6 * s};
  });
  const mesh_outcome made = mesh_of(d, field, with_size());
  CHECK_FALSE(made.complete);
  CHECK(made.disagreeing == 0);
  REQUIRE(made.delivered);
  CHECK(made.delivered->median > most_median_distance);
  REQUIRE(made.intolerable);
  CHECK(made.intolerable->of == intolerable_distance::measure::median);
  CHECK(made.how() == ending::intolerable);
  CHECK(ending_text(made).find("another one than the one wanted") != std::string::npos);

  mesh_options options = with_size();
  options.metric_tolerance = made.delivered->greatest;
  const mesh_outcome wanted_so = mesh_of(d, field, options);
  CHECK(wanted_so.complete);
  CHECK(mesh_fingerprint(wanted_so.result) == mesh_fingerprint(made.result));
}

TEST_CASE("a metric tolerance of 0 leaves every tensor as it is, met or not") {
  const domain d = accepted(square());
  mesh_options options = with_size();
  options.metric_tolerance = 0;
  const formula_field hostile(checkered);
  const mesh_outcome made = mesh_of(d, hostile, options);
  CHECK_FALSE(made.complete);
  CHECK_FALSE(made.delivered);
  REQUIRE(made.intolerable);
  CHECK(made.intolerable->found > 0);
  for (const site& s : made.result.sites) CHECK(identical(s.metric, checkered(s.position)));
  const auto easy = make_metric_field("swirl:3", d.box(), 0.3);
  CHECK(mesh_of(d, *easy.value(), options).complete);
}
