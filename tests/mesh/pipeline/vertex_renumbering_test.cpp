// SPDX-License-Identifier: MIT
//
// Isolated vertices are numbered along a curve while they are meshed, and have their original
// numbers in the mesh.
#include "asterism/mesh/pipeline/vertex_renumbering.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "asterism/core/random.hpp"
#include "asterism/mesh/domain/built_in_domains.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/mesher.hpp"
#include "asterism/mesh/metric/make_metric_field.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"

using namespace asterism;
using namespace asterism::internal;
using vertex_number = asterism::vertex_index;

namespace {

// A square with `count` vertices inside, numbered in the order drawn. A segment joins two of them,
// the others are isolated.
domain square_with_points(std::size_t count) {
  domain d = square();
  splitmix64 random(7);
  for (std::size_t i = 0; i < count; ++i)
    d.vertices.push_back({random.real(-0.9, 0.9), random.real(-0.9, 0.9)});
  d.vertices[count / 2] = {0.95, -0.1};
  d.vertices[count / 2 + 1] = {0.95, 0.1};
  d.segments.push_back(
      {static_cast<vertex_number>(count / 2), static_cast<vertex_number>(count / 2 + 1), 5});
  return check_domain(d).value();
}

std::size_t steps_back(const domain& d) {
  std::size_t back = 0;
  std::uint64_t last = 0;
  for (const point& q : d.vertices) {
    const std::uint64_t place = place_on_curve(q, d.box());
    back += place < last ? 1 : 0;
    last = place;
  }
  return back;
}

bool is_less(const point& p, const point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

}  // namespace

TEST_CASE("few vertices, and those along a curve, keep their numbers while they are meshed") {
  const domain few = square_with_points(100);
  CHECK(&vertex_renumbering(few).shape() == &few);
  const domain many = add_random_points(square(), 6000, 3).value();
  CHECK(&vertex_renumbering(many).shape() == &many);
}

TEST_CASE("many vertices in any order are along a curve while they are meshed") {
  const domain d = square_with_points(6000);
  const vertex_renumbering order(d);
  const domain& shape = order.shape();
  REQUIRE(&shape != &d);
  CHECK(steps_back(d) > d.vertices.size() / 3);
  CHECK(steps_back(shape) < 10);
  for (const segment& s : d.segments)
    for (const vertex_number v : {s.a, s.b}) CHECK(shape.vertices[v] == d.vertices[v]);
  auto before = d.vertices, after = shape.vertices;
  std::sort(before.begin(), before.end(), is_less);
  std::sort(after.begin(), after.end(), is_less);
  CHECK(before == after);
}

TEST_CASE("an outcome in the order of a curve is restored to the order given") {
  const domain d = square_with_points(6000);
  const vertex_renumbering order(d);
  mesh_outcome outcome;
  for (const point& q : order.shape().vertices) outcome.result.sites.push_back({q, {1, 0, 1}});
  outcome.result.sites.push_back({{2, 2}, {1, 0, 1}});  // a vertex that the mesher added
  const auto places_of = [&](const triangle& t) {
    std::vector<point> places;
    for (const vertex_number v : t) places.push_back(outcome.result.sites[v].position);
    std::rotate(places.begin(), std::min_element(places.begin(), places.end(), is_less),
                places.end());
    return places;
  };
  const triangle some{10, 2000, 6004};
  outcome.result.triangles = outcome.result.disagreeing = outcome.exempt_triangles = {some};
  const auto places = places_of(some);
  order.restore(outcome);
  for (std::size_t v = 0; v < d.vertices.size(); ++v)
    REQUIRE(outcome.result.sites[v].position == d.vertices[v]);
  CHECK(outcome.result.sites.back().position == point{2, 2});
  for (const auto* triangles :
       {&outcome.result.triangles, &outcome.result.disagreeing, &outcome.exempt_triangles}) {
    CHECK(places_of(triangles->front()) == places);
    CHECK(*std::min_element(triangles->front().begin(), triangles->front().end()) ==
          triangles->front()[0]);
  }
}

TEST_CASE("a mesh of many vertices has them first, in their order, and is certified") {
  const domain d = square_with_points(6000);
  for (const auto& [metric, angle] :
       {std::pair{"identity", 0.0}, {"swirl:3", 0.0}, {"swirl:3", 20.0}}) {
    INFO(metric << ", " << angle << " degrees");
    const auto field = make_metric_field(metric, d.box(), 1);
    mesh_options options;
    options.angle_bound = angle;
    const auto made = make_certified_mesh(d, *field.value(), options);
    REQUIRE(made.ok());
    CHECK(made.value().certified());
    const mesh& m = made.value().outcome.result;
    REQUIRE(m.given == d.vertices.size());
    for (std::size_t v = 0; v < d.vertices.size(); ++v)
      REQUIRE(m.sites[v].position == d.vertices[v]);
  }
}
