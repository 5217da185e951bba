// SPDX-License-Identifier: MIT
//
// Delivers metrics at the vertices of a mesh: the mesh has the number of sites wanted and is
// certified in the delivered metric, whose distance from the wanted one is reported, and which
// equals the wanted one, bit for bit, where no tensor had to change.
#include "asterism/mesh/delivery/metric_delivery.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "asterism/mesh/audit/audit.hpp"
#include "asterism/mesh/delivery/delivered_metric.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/background_metric.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"
#include "asterism/mesh/pipeline/outcome_text.hpp"
#include "asterism/mesh/support/thread_limit.hpp"
#include "fixtures/domain_kinds.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::testing;

namespace {

// Lengths across and along a direction, in radians.
metric_tensor stretched(double across, double along, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), p = 1 / (across * across),
               q = 1 / (along * along);
  return {p * c * c + q * s * s, (p - q) * c * s, p * s * s + q * c * c};
}

// A front along a circle, as Hessians of solutions with a shock have it.
metric_tensor ring_front(const point& q) {
  const double r = std::hypot(q.x, q.y), d = std::abs(r - 0.6);
  const double across = 0.01 + 0.4 * d, along = std::min(0.15, across * 12);
  return stretched(across, along, std::atan2(q.y, q.x));
}

// Returns a mesh of the square, made without a metric, with the tensors of `metric` at its
// vertices.
mesh background(const std::function<metric_tensor(const point&)>& metric, double size) {
  const domain d = accepted(square());
  const auto field = make_metric_field("identity", d.box(), size);
  mesh_options options;
  options.limit_size = true;
  auto made = make_mesh(d, *field.value(), options);
  REQUIRE(made.ok());
  for (site& s : made.value().result.sites) s.metric = metric(s.position);
  return made.value().result;
}

certified_mesh adapted(const metric_field& field) {
  mesh_options options;
  options.limit_size = true;
  auto made = make_certified_mesh(accepted(square()), field, options);
  REQUIRE(made.ok());
  return std::move(made).value();
}

double wanted_sites(const mesh& of) {
  return 2 / std::numbers::sqrt3 * background_metric(of).complexity();
}

}  // namespace

TEST_CASE(
    "a curved front on a mesh is met with the sites it asks for, certified, three times over") {
  mesh given = background(ring_front, 0.07);
  for (int pass = 0; pass < 3; ++pass) {
    INFO("pass " << pass);
    const auto field = make_interpolated_field(given, 1);
    const certified_mesh made = adapted(*field);
    INFO(ending_text(made.outcome));
    REQUIRE(made.certified());
    CHECK(made.report.worst().degrees >= 20);
    REQUIRE(made.outcome.delivered.has_value());
    CHECK(static_cast<double>(made.outcome.sites) == Approx(wanted_sites(given)).epsilon(0.05));
    CHECK(made.outcome.delivered->beyond_tenth < 0.5);
    given = made.outcome.result;
    for (site& s : given.sites) s.metric = ring_front(s.position);
  }
}

TEST_CASE("a smooth metric on a mesh is delivered to the last bit") {
  const auto smooth = [](const point& q) {
    return stretched(0.05 + 0.01 * q.x, 0.08, 0.3 + 0.2 * q.y);
  };
  const auto field = make_interpolated_field(background(smooth, 0.15), 1);
  const certified_mesh made = adapted(*field);
  REQUIRE(made.certified());
  REQUIRE(made.outcome.delivered.has_value());
  CHECK(made.outcome.delivered->changed == 0);
  CHECK(made.outcome.delivered->greatest == 0);
  for (const site& s : made.outcome.result.sites)
    CHECK(identical(s.metric, field->at(s.position).value()));
}

TEST_CASE("corners that are sharp in the metric alone had low angles beside them, never mended") {
  // Lengths across the diagonal are thirty times as short as along it, so that two corners of the
  // square are below four degrees in the metric.
  const auto diagonal = [](const point&) { return stretched(0.02, 0.6, 0.785); };
  const auto field = make_interpolated_field(background(diagonal, 0.1), 1);
  const certified_mesh made = adapted(*field);
  INFO(ending_text(made.outcome));
  REQUIRE(made.certified());
  REQUIRE(made.outcome.delivered.has_value());
  CHECK(made.report.worst().degrees >= 20);
}

TEST_CASE("the same metric on a mesh gives the same mesh") {
  const auto field = make_interpolated_field(background(ring_front, 0.1), 1);
  const certified_mesh one = adapted(*field), other = adapted(*field);
  CHECK(mesh_fingerprint(one.outcome.result) == mesh_fingerprint(other.outcome.result));
}

TEST_CASE("the work counted is the same for any number of threads") {
  const auto field = make_interpolated_field(background(ring_front, 0.04), 0.2);
  const auto work_with = [&](std::size_t threads) {
    const thread_limit limit(threads);
    constexpr double ample = 1e12;
    mesh_options options;
    options.limit_size = true;
    options.stop = options.stop.with_work(ample);
    const auto made = make_certified_mesh(accepted(square()), *field, options);
    REQUIRE(made.ok());
    REQUIRE(made.value().certified());
    REQUIRE(made.value().outcome.sites > 5000);  // enough for blocks
    return ample - options.stop.units_left();
  };
  const double of_one = work_with(1);
  CHECK(of_one > 1000);
  for (const std::size_t threads : {2U, 3U, 4U}) CHECK(work_with(threads) == of_one);
}

TEST_CASE("what a certificate says of the metric delivered is measured again") {
  const auto field = make_interpolated_field(background(ring_front, 0.1), 1);
  certified_mesh made = adapted(*field);
  const mesh& m = made.outcome.result;
  REQUIRE(made.claim.delivered.has_value());
  CHECK(contradictions_in_delivered(m, made.claim, *field).empty());
  certificate altered = made.claim;
  altered.delivered->greatest /= 2;
  CHECK(contradictions_in_delivered(m, altered, *field).size() == 1);
  altered = made.claim;
  altered.delivered->low_wanted.push_back(0);
  altered.delivered->changed += 1;
  CHECK(contradictions_in_delivered(m, altered, *field).size() == 2);
}

TEST_CASE("distances of tensors whose ratios have no double were none") {
  mesh m = background([](const point&) { return metric_tensor{1e-200, 0, 1e200}; }, 1);
  const auto field = make_metric_field("expr:1e200;0;1e-200", accepted(square()).box(), 1);
  const auto compared = compare_with_wanted(m, *field.value(), 20);
  REQUIRE(compared);
  CHECK(compared.value().greatest == Approx(200 * std::log(10)));
  CHECK(compared.value().median == compared.value().greatest);
  for (site& s : m.sites) s.metric = {1e-300, 0, 1e-300};
  const auto farther = compare_with_wanted(m, *field.value(), 20);
  REQUIRE(farther);
  CHECK(farther.value().greatest == Approx(250 * std::log(10)));
}

TEST_CASE("an adaptation that is stopped says so and claims nothing") {
  const auto field = make_interpolated_field(background(ring_front, 0.1), 1);
  mesh_options options;
  options.limit_size = true;
  options.stop = [] { return std::optional<std::string>("enough"); };
  const auto made = make_mesh(accepted(square()), *field, options);
  REQUIRE(made.ok());
  CHECK(made.value().stopped);
  CHECK_FALSE(made.value().complete);
}
