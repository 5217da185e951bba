// SPDX-License-Identifier: MIT
//
// Compares measures in metrics of great aspect with quadruple precision, in which products of two
// doubles are exact.
#include "asterism/mesh/numerics/ill_conditioned_metric.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/mesh_statistics.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using test::splitmix64;

namespace {

__extension__ using quadruple = __float128;

constexpr double aspects[] = {300, 1e4, 1e6, 3e7};

// Returns the tensor with length 1 along `degrees` and 1 / aspect across. It is positive definite
// as rounded up to an aspect of 3e7.
metric_tensor turned(double aspect, double degrees) {
  const double turn = degrees * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
  const double w = 1 / (aspect * aspect);
  return {c * c + w * s * s, (1 - w) * c * s, s * s + w * c * c};
}

double exact_determinant(const metric_tensor& m) {
  return static_cast<double>(quadruple(m.m11) * m.m22 - quadruple(m.m12) * m.m12);
}

// Exact except for the last of 113 bits, if the terms are of similar size.
double exact_squared_length(const metric_tensor& m, double x, double y) {
  return static_cast<double>(m.m11 * (quadruple(x) * x) + 2 * m.m12 * (quadruple(x) * y) +
                             m.m22 * (quadruple(y) * y));
}

// Returns a triangle placed along the long direction. In the metric it is equilateral except for
// its height.
triangle_sites thin_triangle(double aspect, double degrees, double height) {
  const metric_tensor m = turned(aspect, degrees);
  const round_coordinates round({0, 0}, m);
  const auto at = [&](double x, double y) { return site{round.outward({x, y}), m}; };
  return {at(0, 0), at(1, 0), at(0.5, height)};
}

}  // namespace

TEST_CASE("thin: which metrics are") {
  CHECK_FALSE(is_thin({1, 0, 1}));
  CHECK_FALSE(is_thin({1, 0, 1e-20}));  // nothing cancels here
  CHECK_FALSE(is_thin(turned(100, 45)));
  for (const double aspect : aspects) CHECK(is_thin(turned(aspect, 30)));
}

TEST_CASE("thin: determinants and lengths are those of the tensor as it is, to the last bits") {
  splitmix64 random(11);
  for (const double aspect : aspects)
    for (int i = 0; i < 300; ++i) {
      const double degrees = random.real(0, 180);
      const metric_tensor m = turned(aspect, degrees);
      INFO("replay: aspect " << aspect << ", pair " << i << ", degrees " << degrees);
      const double det = exact_determinant(m);
      REQUIRE(det > 0);
      CHECK(root_of_determinant(m) == Approx(std::sqrt(det)).epsilon(1e-14));
      CHECK(least_across(m.m11, m.m12, m.m22) == Approx(det / m.m22).epsilon(1e-14));
      const double turn = (degrees + 90) * std::numbers::pi / 180;
      const double x = aspect * std::cos(turn), y = aspect * std::sin(turn);
      const double length = exact_squared_length(m, x, y);
      CHECK(squared_length_of_thin(m, x, y) == Approx(length).epsilon(1e-14));
      CHECK(squared_length(m, {x, y}) == Approx(length).epsilon(1e-11));
    }
}

TEST_CASE("thin: products of entries may leave the range of doubles") {
  for (const double scale : {0x1p-800, 0x1p800})
    CHECK(root_of_determinant({4 * scale, 0, 9 * scale}) == 6 * scale);
}

TEST_CASE("thin: in round coordinates the metric is the identity and lengths stay") {
  splitmix64 random(12);
  for (const double aspect : aspects)
    for (int i = 0; i < 300; ++i) {
      const metric_tensor m = turned(aspect, random.real(0, 180));
      INFO("replay: aspect " << aspect << ", tensor " << i);
      const round_coordinates round({5, -3}, m);
      const point u{random.real(-1, 1), random.real(-1, 1)};
      const point d = round.outward(u);
      const site back = round.inward({{5 + d.x, -3 + d.y}, m});
      const double off = 1e-14 * aspect;
      CHECK(std::hypot(back.position.x - u.x, back.position.y - u.y) < off);
      CHECK(back.metric.m11 == Approx(1).margin(off));
      CHECK(back.metric.m12 == Approx(0).margin(off));
      CHECK(back.metric.m22 == Approx(1).margin(off));
      CHECK(squared_length(m, d) == Approx(u.x * u.x + u.y * u.y).margin(off));
    }
}

TEST_CASE("thin: equal tensors differ by nothing") {
  // Rounding in the plain formula gives a distortion of 1.01 at an aspect of 1e6, by which a
  // constant metric seems to vary fast.
  for (const double aspect : aspects)
    for (const double degrees : {10.0, 45.0, 80.0}) {
      const metric_tensor m = turned(aspect, degrees);
      CHECK(distortion(m, m) == Approx(1).margin(1e-6));
      CHECK(distortion(m, {4 * m.m11, 4 * m.m12, 4 * m.m22}) == Approx(2).epsilon(1e-6));
    }
}

TEST_CASE("thin: circumradius and angles are those of the triangle as the metric sees it") {
  const double equilateral = std::numbers::sqrt3 / 2;
  for (const double aspect : aspects)
    for (const double degrees : {10.0, 45.0, 80.0}) {
      INFO("aspect " << aspect << ", turned by " << degrees);
      const triangle_sites t = thin_triangle(aspect, degrees, equilateral);
      CHECK(smallest_angle(t) == Approx(60).epsilon(1e-6));
      CHECK(corner_angle(t[0], t[1].position, t[2].position) == Approx(60).epsilon(1e-6));
      CHECK(metric_circumradius(t) == Approx(1 / std::numbers::sqrt3).epsilon(1e-6));
      const auto vertices = voronoi_vertices(t[0], t[1], t[2]);
      REQUIRE(vertices.size() == 1);
      for (const site& s : t)
        CHECK(squared_distance(s, vertices[0]) == Approx(1.0 / 3).epsilon(1e-6));
    }
}

TEST_CASE("thin: no good triangle is taken for low") {
  // From aspect 1e7 on, error bounds in doubles exceed both sides of the comparison.
  const angle_requirement twenty(20);
  for (const double aspect : aspects)
    for (const double degrees : {10.0, 45.0, 80.0}) {
      INFO("aspect " << aspect << ", turned by " << degrees);
      const auto height_for = [](double angle) {
        return 0.5 * std::tan(angle * std::numbers::pi / 180);
      };
      CHECK_FALSE(twenty.is_low(thin_triangle(aspect, degrees, height_for(20.01))));
      CHECK(twenty.is_low(thin_triangle(aspect, degrees, height_for(19.99))));
    }
}
