// SPDX-License-Identifier: MIT
#include "asterism/mesh/delivery/tolerated_metric.hpp"

#include <catch2/catch.hpp>

#include "asterism/mesh/pipeline/outcome_text.hpp"

using namespace asterism;
using namespace asterism::internal;
using measure = intolerable_distance::measure;

namespace {

mesh_outcome delivered(double median, double greatest, double wanted, double got) {
  mesh_outcome made;
  made.delivered.emplace();
  made.delivered->median = median;
  made.delivered->greatest = greatest;
  made.delivered->complexity_wanted = wanted;
  made.delivered->complexity_delivered = got;
  return made;
}

}  // namespace

// Gives two crossing fronts on a grid of 128,000 vertices, for which the work limit is reached. The
// mesh in one metric for all sites then has 274 of them. Half of these lie in the flat part and
// have the tensors wanted, so that a median of distances passes; the density of the metric does
// not. The status must not be 0.
TEST_CASE(
    "a metric 300 times as thin as the one wanted passed for it, as half of the sites had theirs") {
  mesh_outcome made = delivered(0, 7.2, 66716.1, 194.951);
  made.intolerable = excess_of(made, {});
  REQUIRE(made.intolerable);
  CHECK(made.intolerable->of == measure::density);
  CHECK(made.intolerable->found > 342);
  CHECK(made.intolerable->allowed == most_density_ratio);
  made.ended.how = ending::complete;
  CHECK(ending_text(made).find("on the whole it is 342.2 times as thin") != std::string::npos);
  made = delivered(0, 7.2, 194.951, 66716.1);
  made.intolerable = excess_of(made, {});
  REQUIRE(made.intolerable);
  CHECK(ending_text(made).find("on the whole it is 342.2 times as dense") != std::string::npos);
}

TEST_CASE("what is tolerated of a metric delivered") {
  CHECK_FALSE(excess_of({}, {}));
  CHECK_FALSE(excess_of(delivered(2.3, 9, 1, 10), {}));
  CHECK_FALSE(excess_of(delivered(2.3, 9, 10, 1), {}));
  const auto median = excess_of(delivered(2.31, 9, 1, 1), {});
  REQUIRE(median);
  CHECK(median->of == measure::median);
  CHECK(median->greatest == 9);
  CHECK_FALSE(excess_of(delivered(0, 9, 0, 0), {}));  // without a ratio the median decides

  mesh_options options;
  options.metric_tolerance = 9;
  CHECK_FALSE(excess_of(delivered(5, 9, 1, 1000), options));
  options.metric_tolerance = 8.9;
  const auto greatest = excess_of(delivered(0, 9, 1, 1), options);
  REQUIRE(greatest);
  CHECK(greatest->of == measure::greatest);
  mesh_outcome stopped = delivered(5, 9, 1, 1000);
  stopped.stopped = true;
  CHECK_FALSE(excess_of(stopped, {}));
}
