// SPDX-License-Identifier: MIT
//
// A field given at vertices: bit for bit there, log-Euclidean between them, clamped outside.
#include "asterism/mesh/metric/interpolated_field.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::test;

namespace {

mesh two_triangles() {
  mesh m = make_mesh_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  m.sites[0].metric = {1, 0, 1};
  m.sites[1].metric = {16, 0, 4};
  m.sites[2].metric = {64, 0, 0.25};
  m.sites[3].metric = {3, 1, 2};
  return m;
}

}  // namespace

TEST_CASE("a vertex has its own tensor, bit for bit") {
  patch p = make_patch(6);
  splitmix64 random(3);
  for (site& s : p.m.sites) s.metric = {random.real(1, 9), random.real(-1, 1), 2};
  const auto field = make_interpolated_field(p.m);
  for (const site& s : p.m.sites) {
    const auto m = field->at(s.position);
    REQUIRE(m.ok());
    CHECK(identical(m.value(), s.metric));
  }
}

TEST_CASE("between vertices logarithms are interpolated") {
  const auto field = make_interpolated_field(two_triangles());
  const auto m = field->at({0.5, 0});
  REQUIRE(m.ok());
  CHECK(m.value().m11 == Approx(4));  // the geometric mean of 1 and 16
  CHECK(m.value().m22 == Approx(2));
  const auto middle = field->at({0.75, 0.25});  // half of vertex 2, quarters of 1 and 3
  REQUIRE(middle.ok());
  CHECK(middle.value().m11 == Approx(std::sqrt(16.0) * std::sqrt(std::sqrt(64.0))));
  CHECK(middle.value().m22 == Approx(std::sqrt(4.0) * std::sqrt(std::sqrt(0.25))));
}

TEST_CASE("outside of all triangles it goes on as on the rim") {
  const auto field = make_interpolated_field(two_triangles());
  for (const double away : {1e-16, 1e-9, 0.1, 30.0}) {
    CAPTURE(away);
    const auto m = field->at({0.5, -away});
    REQUIRE(m.ok());
    if (away < 1e-3) CHECK(m.value().m11 == Approx(4).epsilon(1e-6));
  }
}

TEST_CASE("a flat or clockwise triangle has no say") {
  mesh m = two_triangles();
  m.triangles.push_back({0, 2, 1});
  const auto field = make_interpolated_field(m), plain = make_interpolated_field(two_triangles());
  CHECK(identical(field->at({0.6, 0.3}).value(), plain->at({0.6, 0.3}).value()));
}
