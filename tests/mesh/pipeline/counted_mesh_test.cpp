// SPDX-License-Identifier: MIT
//
// Makes meshes with the number of vertices wanted, in metrics that alone would give more.
#include "asterism/mesh/pipeline/counted_mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "asterism/mesh/domain/divide_curves.hpp"
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

// A moon between two arcs through the same two points.
domain moon() {
  domain d;
  d.vertices = {{-1, 0}, {1, 0}};
  d.segments = {{0, 1, 1}, {1, 0, 2}};
  for (const auto& [centre, segment] : {std::pair{point{0, 1}, 0U}, std::pair{point{0, 1.1}, 1U}}) {
    domain_curve arc;
    arc.centre = centre;
    arc.clockwise = segment == 1;
    arc.vertices = {d.segments[segment].a, d.segments[segment].b};
    arc.parameters = {0, 1};
    arc.segment = segment;
    d.curves.push_back(arc);
  }
  const auto divided = divide_curves(d);
  REQUIRE(divided.ok());
  auto checked = check_domain(divided.value());
  REQUIRE(checked.ok());
  return std::move(checked).value();
}

field_in_box in_metric(const std::string& spec) {
  return
      [spec](double size, const bounding_box& box) { return make_metric_field(spec, box, size); };
}

result<certified_mesh> made_of(const mesh_input& input, const mesh_options& options) {
  return make_certified_mesh(input.shape, *input.metric.field, options);
}

double off(std::size_t wanted, const certified_mesh& made) {
  return std::abs(static_cast<double>(made.outcome.sites) / static_cast<double>(wanted) - 1);
}

mesh_options options_for(std::size_t wanted) {
  mesh_options options;
  options.limit_size = true;
  options.vertices = wanted;
  return options;
}

// Returns the mesh of the attempt whose number of vertices is near the one wanted.
counted_mesh made_near(std::size_t wanted, const mesh_source& source) {
  auto made = make_counted_mesh(source, options_for(wanted), made_of);
  REQUIRE(made.ok());
  CHECK(made.value().made.certified());
  CHECK(is_count_near(wanted, made.value().made.outcome.sites));
  return std::move(made).value();
}

}  // namespace

TEST_CASE(
    "the metric was scaled once, and a narrow strip had other numbers of vertices than were "
    "wanted") {
  constexpr std::size_t wanted = 24;
  const mesh_options options = options_for(wanted);
  const mesh_source source{strip(), in_metric("identity")};
  const auto first = prepare_mesh_input(source, options);
  REQUIRE(first.ok());
  const auto once = made_of(first.value(), options);
  REQUIRE(once.ok());
  CHECK(off(wanted, once.value()) > 0.05);
  CHECK(made_near(wanted, source).input.metric.complexity);
}

TEST_CASE("chords of curves stayed as the first density wanted them when a number was met") {
  constexpr std::size_t wanted = 600;
  const mesh_source source{moon(), in_metric("identity")};
  const auto first = prepare_mesh_input(source, options_for(wanted));
  REQUIRE(first.ok());
  const counted_mesh made = made_near(wanted, source);
  const domain& shape = made.input.shape;
  CHECK(shape.segments.size() != first.value().shape.segments.size());
  CHECK(shape.segments.size() > source.shape.segments.size());
}

TEST_CASE("a density divides curves and scales the metric, and leaves the rest of a source") {
  const mesh_options options = options_for(500);
  mesh_source source{moon(), in_metric("identity")};
  source.random_points = 7;
  const auto coarse = prepare_mesh_input(source, options),
             fine = prepare_mesh_input(source, options, 4);
  REQUIRE(coarse.ok());
  REQUIRE(fine.ok());
  CHECK(fine.value().shape.segments.size() > coarse.value().shape.segments.size());
  CHECK(std::abs(*fine.value().metric.complexity / *coarse.value().metric.complexity - 4) < 0.08);
  CHECK(coarse.value().given == coarse.value().shape.vertices.size());
  source.metric = in_metric("no such metric");
  CHECK_FALSE(prepare_mesh_input(source, options).ok());
}

TEST_CASE("without a number wanted the metric has the size asked for") {
  mesh_source source{strip(), in_metric("identity")};
  source.scale.size = 0.02;
  mesh_options options;
  options.limit_size = true;
  const auto made = make_counted_mesh(source, options, made_of);
  REQUIRE(made.ok());
  CHECK(made.value().made.certified());
  CHECK(made.value().input.metric.size == 0.02);
  CHECK_FALSE(made.value().input.metric.complexity);
  source.scale.size = -1;
  CHECK_FALSE(make_counted_mesh(source, options, made_of).ok());
}
