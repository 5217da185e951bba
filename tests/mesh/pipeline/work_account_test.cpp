// SPDX-License-Identifier: MIT
//
// Tests the account of the work of a run (mesh/support/cancellation.hpp).
#include <catch2/catch.hpp>
#include <limits>
#include <optional>
#include <string>

#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/make_mesh.hpp"
#include "asterism/mesh/support/cancellation.hpp"

using namespace asterism;

TEST_CASE("without an account there is always work left", "[work_account]") {
  const cancellation stop;
  stop.charge(1e300);
  stop.expect(1000);
  CHECK(stop.units_left() == std::numeric_limits<double>::infinity());
  CHECK(stop.part(0.5).units_left() == std::numeric_limits<double>::infinity());
  CHECK_FALSE(stop.is_requested());
}

TEST_CASE("an account that is used up asks for an end, and is no question of the caller's",
          "[work_account]") {
  const cancellation stop = cancellation().with_work(10);
  CHECK_FALSE(stop.is_requested());
  const cancellation same = stop;
  same.charge(10);
  CHECK(stop.units_left() == 0);
  CHECK(stop.poll() == "the most work that is done for one run was done");
  CHECK_FALSE(stop.told());
}

TEST_CASE("what a part is charged is taken off the whole", "[work_account]") {
  const cancellation whole = cancellation().with_work(100, 2);
  const cancellation part = whole.part(0.25);
  CHECK(part.units_left() == 25);
  part.charge(25);
  CHECK(part.is_requested());
  CHECK(whole.units_left() == 75);
  CHECK(whole.part(2).units_left() == 75);
  // Expecting a larger mesh increases the work in the account, and a part's by its share. Expecting
  // the same mesh again changes nothing.
  part.expect(10);
  CHECK(whole.units_left() == 95);
  CHECK(part.units_left() == 5);
  part.expect(10);
  whole.expect(9);
  CHECK(whole.units_left() == 95);
}

TEST_CASE("a run without work left ends with what there is, and says so", "[work_account]") {
  const domain d = square();
  const auto field = make_metric_field("swirl:12", d.box(), 0.05);
  REQUIRE(field);
  mesh_options options;
  options.limit_size = true;
  options.metric_tolerance = 0;
  options.stop = options.stop.with_work(5);
  const auto made = make_mesh(d, *field.value(), options);
  REQUIRE(made);
  CHECK_FALSE(made.value().complete);
  CHECK_FALSE(made.value().stopped);
  const auto again = make_mesh(d, *field.value(), [&] {
    mesh_options same = options;
    same.stop = cancellation().with_work(5);
    return same;
  }());
  REQUIRE(again);
  CHECK(again.value().result.sites.size() == made.value().result.sites.size());
}
