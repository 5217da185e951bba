// SPDX-License-Identifier: MIT
//
// Meshes with as many vertices as are wanted, where the metric alone would have more.
#include "asterism/mesh/pipeline/counted_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "asterism/mesh/mesher.hpp"

using namespace asterism;

namespace {

// A strip whose boundary takes more vertices than its area.
domain strip() {
  domain d;
  d.vertices = {{0, 0}, {1, 0}, {1, 0.01}, {0, 0.01}};
  for (asterism::vertex_index k = 0; k < 4; ++k) d.segments.push_back({k, (k + 1) % 4, 1});
  auto checked = check_domain(d);
  REQUIRE(checked.ok());
  return std::move(checked).value();
}

field_of_size in_metric(const std::string& spec, const domain& d) {
  return [spec, &d](double size) { return make_metric_field(spec, d.box(), size); };
}

double off(std::size_t wanted, const certified_mesh& made) {
  return std::abs(static_cast<double>(made.outcome.sites) / static_cast<double>(wanted) - 1);
}

}  // namespace

TEST_CASE(
    "the metric was scaled once, and a narrow strip had other numbers of vertices than were "
    "wanted") {
  const domain d = strip();
  constexpr std::size_t wanted = 40;
  const auto metric = in_metric("identity", d);
  scale_demand scale;
  scale.complexity = complexity_of_vertices(wanted);
  mesh_options options;
  options.limit_size = true;
  options.vertices = wanted;
  const auto scaled = make_scaled_metric(d, metric, scale);
  REQUIRE(scaled.ok());
  const auto once = make_certified_mesh(d, *scaled.value().field, options);
  REQUIRE(once.ok());
  CHECK(off(wanted, once.value()) > 0.05);

  const auto made = make_counted_mesh(d, metric, {}, options);
  REQUIRE(made.ok());
  CHECK(made.value().made.certified());
  CHECK(off(wanted, made.value().made) <= 0.05);
  CHECK(made.value().metric.complexity);
}

TEST_CASE("without a number wanted the metric has the size asked for") {
  const domain d = strip();
  scale_demand scale;
  scale.size = 0.02;
  mesh_options options;
  options.limit_size = true;
  const auto made = make_counted_mesh(d, in_metric("identity", d), scale, options);
  REQUIRE(made.ok());
  CHECK(made.value().made.certified());
  CHECK(made.value().metric.size == 0.02);
  CHECK_FALSE(made.value().metric.complexity);
  scale.size = -1;
  CHECK_FALSE(make_counted_mesh(d, in_metric("identity", d), scale, options).ok());
}
