// SPDX-License-Identifier: MIT
//
// Metrics scaled to a complexity and graded in turns, and requests that are refused.
#include "asterism/mesh/pipeline/scaled_metric.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/mesh/delivery/metric_complexity.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/interpolated_field.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

field_of_size of_spec(const std::string& spec) {
  return [spec](double size) { return make_metric_field(spec, square().box(), size); };
}

double measured(const std::string& spec) {
  const auto field = make_metric_field(spec, square().box());
  const auto found = complexity_over(square(), *field.value(), {});
  REQUIRE(found.ok());
  return found.value();
}

// Sizes jump by a factor of fifty between two rows of vertices.
mesh with_jump() {
  const auto field = make_metric_field("identity", square().box(), 0.2);
  mesh_options options;
  options.limit_size = true;
  auto made = make_mesh(square(), *field.value(), options);
  REQUIRE(made.ok());
  for (site& s : made.value().result.sites)
    s.metric = s.position.y > 0 ? metric_tensor{2500, 0, 2500} : metric_tensor{1, 0, 1};
  return made.value().result;
}

}  // namespace

TEST_CASE("the complexity of a formula is its integral, to a thousandth") {
  CHECK(measured("identity") == Approx(4));
  // sqrt det = 1 + 9 x^2: 4 + 12 on the square of side 2.
  CHECK(measured("expr:(1+9*x^2)^2;0;1") == Approx(16).epsilon(1e-3));
  // A ridge 0.03 wide: sqrt(pi) / 30 across, 2 along, and the plane's 4.
  CHECK(measured("expr:(1+1000*exp(-900*x^2))^2;0;1") ==
        Approx(4 + 2000 * std::sqrt(3.14159265358979) / 30).epsilon(1e-3));
}

TEST_CASE("a metric is scaled to the complexity in one turn") {
  scale_demand wanted;
  wanted.complexity = 400;
  const auto made = make_scaled_metric(square(), of_spec("identity"), wanted);
  REQUIRE(made.ok());
  CHECK(made.value().size == Approx(0.1));
  CHECK(made.value().complexity.value() == Approx(400));
  CHECK(complexity_of_vertices(1000) == Approx(866.0254));
}

TEST_CASE("grading and scaling by turns meet a complexity that grading changes") {
  const mesh given = with_jump();
  const field_of_size make = [&given](double size) -> result<std::unique_ptr<metric_field>> {
    return make_interpolated_field(given, size);
  };
  scale_demand wanted;
  wanted.complexity = 3000;
  wanted.gradation = 1.2;
  const auto made = make_scaled_metric(square(), make, wanted);
  REQUIRE(made.ok());
  CHECK(made.value().complexity.value() == Approx(3000).epsilon(0.005));
  REQUIRE(made.value().gradation.has_value());
  CHECK(made.value().gradation->changed > 0);
  CHECK(made.value().gradation->settled);
  // Gradation made no tensor smaller.
  const mesh& graded = *made.value().field->background();
  const double factor = 1 / (made.value().size * made.value().size);
  for (std::size_t v = 0; v < given.sites.size(); ++v)
    CHECK(graded.sites[v].metric.m11 >= given.sites[v].metric.m11 * factor * (1 - 1e-12));
}

TEST_CASE("sizes at places are not scaled: little above them is met, and less is refused") {
  scale_demand wanted;
  wanted.sizes.at = {{{0, 0}, 0.5, 0.05, 1.2}};
  wanted.size = 1e3;
  const auto alone = make_scaled_metric(square(), of_spec("identity"), wanted);
  REQUIRE(alone.ok());
  const double least = complexity_over(square(), *alone.value().field, {}).value();
  wanted.size.reset();
  wanted.complexity = 1.02 * least;
  const auto made = make_scaled_metric(square(), of_spec("identity"), wanted);
  REQUIRE(made.ok());
  CHECK(made.value().complexity.value() == Approx(1.02 * least).epsilon(0.005));
  wanted.complexity = 0.5 * least;
  wanted.vertices = 100;
  const auto fails = make_scaled_metric(square(), of_spec("identity"), wanted);
  REQUIRE_FALSE(fails.ok());
  CHECK(fails.failure().message.find(
            "100 vertices were wanted, and sizes and layers at places, which are not scaled, take "
            "about 200") == 0);
}

TEST_CASE("what cannot be scaled is refused, and a run that is stopped says so") {
  scale_demand wanted;
  wanted.complexity = -1;
  CHECK_FALSE(make_scaled_metric(square(), of_spec("identity"), wanted).ok());
  wanted.complexity = 100;
  const auto fails = make_scaled_metric(square(), of_spec("expr:x;0;1"), wanted);
  REQUIRE_FALSE(fails.ok());
  CHECK(fails.failure().message.find("not positive definite") != std::string::npos);
  wanted.stop = [] { return std::optional<std::string>("enough"); };
  const auto stopped = make_scaled_metric(square(), of_spec("swirl:12"), wanted);
  REQUIRE_FALSE(stopped.ok());
}
