// SPDX-License-Identifier: MIT
//
// Tests the auditor's bounds of few operations: of the distance from a site to a segment, and of a
// gap's reach.
#include "asterism/mesh/audit/metric_ball.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/mesh/audit/distant_site.hpp"
#include "asterism/mesh/audit/gap_reach.hpp"
#include "fixtures/audit_meshes.hpp"

using namespace asterism;
using namespace asterism::internal;
using namespace asterism::internal::audit_detail;
using namespace asterism::test;

TEST_CASE("a ball certainly misses only segments that are farther, and most of these") {
  const std::uint64_t seed = 80;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t missed = 0, farther = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto somewhere = [&] { return point{random.real(-2, 2), random.real(-2, 2)}; };
    const site w{somewhere(), random_metric(random, i % 2 == 0 ? 1.0 : 4.0)};
    const point a = somewhere(), b = somewhere();
    const metric_ball ball(w);
    if (!ball.is_usable()) continue;
    using real = long double;
    const real ax = real{a.x} - w.position.x, ay = real{a.y} - w.position.y, ex = real{b.x} - a.x,
               ey = real{b.y} - a.y;
    const auto product = [&w](real px, real py, real qx, real qy) {
      return px * (w.metric.m11 * qx + w.metric.m12 * qy) +
             py * (w.metric.m12 * qx + w.metric.m22 * qy);
    };
    const real share =
        std::fmin(real{1}, std::fmax(real{0}, -product(ax, ay, ex, ey) / product(ex, ey, ex, ey)));
    const real x = ax + share * ex, y = ay + share * ey;
    const auto distance = static_cast<double>(std::sqrt(product(x, y, x, y)));
    const point p = ball.in_frame(a), q = ball.in_frame(b);
    CAPTURE(i, distance);
    for (const double radius : {0.5 * distance, distance * (1 - 0x1p-16), distance * (1 + 0x1p-22),
                                distance, 2 * distance}) {
      const bool misses = metric_ball::misses(p, q, radius);
      if (misses) REQUIRE(distance > radius);
      missed += misses ? 1 : 0;
      farther += distance > radius ? 1 : 0;
    }
  }
  CHECK(missed > 9 * farther / 10);
}

TEST_CASE("no accepted site is beyond the quick reach of its gap") {
  const std::uint64_t seed = 81;
  CAPTURE(seed);
  splitmix64 random(seed);
  const filtered_kernel kernel;
  std::size_t accepted = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double strength = i % 3 == 0 ? 0.1 : i % 3 == 1 ? 0.5 : 1.5;
    const auto somewhere = [&] {
      return site{{random.real(-1, 1), random.real(-1, 1)}, random_metric(random, strength)};
    };
    const site v = somewhere(), x = somewhere(), y = somewhere(), w = somewhere();
    const auto turn = [&](const site& a, const site& b, const site& c) {
      return kernel.orientation(a.position, b.position, c.position);
    };
    if (turn(v, x, y) != sign::positive || turn(v, x, w) != sign::positive ||
        turn(v, w, y) != sign::positive || turn(x, y, w) != sign::negative)
      continue;
    if (!kernel.edge_test(v, w, x, y)) continue;
    const double reach = quick_reach(v, x, y);
    if (!std::isfinite(reach)) continue;
    CAPTURE(i);
    ++accepted;
    REQUIRE_FALSE(is_too_far(v, reach, w));
  }
  CHECK(accepted > 1000);
}

TEST_CASE("a gap that is said to have a quick reach has one, and most are said to") {
  const std::uint64_t seed = 83;
  CAPTURE(seed);
  splitmix64 random(seed);
  std::size_t said = 0, finite = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double strength = i % 2 == 0 ? 0.3 : 3.0;
    const auto somewhere = [&] {
      return site{{random.real(-1, 1), random.real(-1, 1)}, random_metric(random, strength)};
    };
    const site v = somewhere(), x = somewhere(), y = somewhere();
    CAPTURE(i);
    const bool is_finite = std::isfinite(quick_reach(v, x, y)), is_said = has_quick_reach(v, x, y);
    if (is_said) REQUIRE(is_finite);
    said += is_said ? 1 : 0;
    finite += is_finite ? 1 : 0;
  }
  CHECK(finite > 10'000);
  CHECK(said > 8 * finite / 10);
}
