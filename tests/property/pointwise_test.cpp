// SPDX-License-Identifier: MIT
//
// Compares the predicates about given points of every kernel with the oracle's.
#include <array>

#include "agreement.hpp"
#include "asterism/tests/oracle/oracle.hpp"

namespace asterism::property {
namespace {

// Triples that are collinear or nearly: multiples of a difference, moved by a unit in the last
// place.
std::array<point, 3> draw_triple(random_source& random) {
  const auto coordinate = [&random] {
    return random.chance(2) ? double(random.integer(-9, 9)) : random.real(-1, 1);
  };
  const point p = {coordinate(), coordinate()}, q = {coordinate(), coordinate()};
  const double t = random.integer(-3, 3) * (random.chance(2) ? 1 : 0.1);
  point r = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  if (random.chance(3)) r.x += r.x * 0x1p-52;
  return {p, q, r};
}

TEST_CASE("orientation agrees with the oracle", "[property]") {
  random_source random(11);
  for (int i = 0; i < 20000; ++i) {
    const auto points = draw_triple(random);
    const point &p = points[0], &q = points[1], &r = points[2];
    expect_agreement(
        oracle::orientation(p, q, r),
        [&](const auto& kernel) { return kernel.orientation(p, q, r); },
        record("orientation", {}, points));
  }
}

TEST_CASE("positive definiteness agrees with the oracle", "[property]") {
  random_source random(12);
  for (int i = 0; i < 20000; ++i) {
    metric_tensor m = {double(random.integer(-2, 9)), double(random.integer(-4, 4)),
                       double(random.integer(-2, 9))};
    if (random.chance(2)) {  // on or next to the semidefinite cone
      const double a = random.real(-2, 2), b = random.real(-2, 2);
      m = {a * a, a * b, b * b};
    }
    const int exponent = random.chance(2) ? 0 : random.integer(-400, 400);
    const site s = scaled({{0, 0}, m}, 0, exponent);
    const std::array<point, 1> numbers = {point{s.metric.m11, s.metric.m12}};
    expect_agreement(
        oracle::is_positive_definite(s.metric),
        [&](const auto& kernel) { return kernel.is_positive_definite(s.metric); },
        record("is_spd", {}, numbers) + " and m22 " + std::to_string(s.metric.m22));
  }
}

TEST_CASE("predicates about a point and two sites agree with the oracle", "[property]") {
  for_each_case(300, [](const four_sites& sites, random_source& random) {
    const site &v = sites[0], &w = sites[1];
    const std::array<point, 1> points = {draw_point(sites, random)};
    const point& p = points[0];
    const std::span<const site> pair(sites.data(), 2);
    expect_agreement(
        oracle::compare_distance(v, w, p),
        [&](const auto& kernel) { return kernel.compare_distance(v, w, p); },
        record("compare_distance", pair, points));
    expect_agreement(
        oracle::in_wedge(v, w, p), [&](const auto& kernel) { return kernel.in_wedge(v, w, p); },
        record("in_wedge", pair, points));
    expect_agreement(
        oracle::dominates(v, w, p), [&](const auto& kernel) { return kernel.dominates(v, w, p); },
        record("dominates", pair, points));
  });
}

TEST_CASE("in_circle agrees with the oracle", "[property]") {
  for_each_case(300, [](const four_sites& sites, random_source& random) {
    const metric_tensor& m = sites[0].metric;
    const point &a = sites[0].position, &b = sites[1].position, &c = sites[2].position;
    const point p = random.chance(2) ? sites[3].position : draw_point(sites, random);
    const std::array<point, 4> points = {a, b, c, p};
    const sign expected = oracle::in_circle(m, a, b, c, p);
    const std::string replay =
        record("in_circle", {}, points) + " in the metric of " + record("site", {sites.data(), 1});
    expect_agreement(
        expected, [&](const auto& kernel) { return kernel.in_circle(m, a, b, c, p); }, replay);
    static const filtered_kernel plane;
    expect_equal(oracle::in_circle({1, 0, 1}, a, b, c, p), plane.in_circle(a, b, c, p), replay,
                 "in the plane");
  });
}

TEST_CASE("encroachment agrees with the oracle", "[property]") {
  for_each_case(300, [](const four_sites& sites, random_source&) {
    const site &a = sites[0], &b = sites[1], &w = sites[2];
    expect_agreement(
        oracle::encroaches(a, b, w), [&](const auto& kernel) { return kernel.encroaches(a, b, w); },
        record("encroaches", {sites.data(), 3}));
  });
}

}  // namespace
}  // namespace asterism::property
