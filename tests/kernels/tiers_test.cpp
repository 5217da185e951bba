// SPDX-License-Identifier: MIT
//
// Checks which tier decides: clear cases never reach exact arithmetic, exact ties always do, and on
// a fixed sample of smooth metrics the share that falls through is bounded.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>

#include "asterism/core/random.hpp"
#include "asterism/kernels/double_kernel.hpp"
#include "asterism/kernels/exact_kernel.hpp"
#include "asterism/kernels/filtered_edge_test.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/kernels/interval_kernel.hpp"

using namespace asterism;

namespace {

constexpr metric_tensor round_metric{1, 0, 1};

site swirl_site(double x, double y) {
  return {{x, y}, {1 + 12 * x * x, 12 * x * y, 1 + 12 * y * y}};
}

using sequence = internal::splitmix64;

}  // namespace

TEST_CASE("clear signs never reach exact arithmetic", "[tiers]") {
  tier_counters decided;
  const filtered_kernel kernel(decided);
  CHECK(kernel.orientation({0, 0}, {1, 0}, {0, 1}) == sign::positive);
  CHECK(kernel.edge_test(swirl_site(0.1, 0), swirl_site(-0.1, 0), swirl_site(0, 0.3),
                         swirl_site(0, -0.3)));
  CHECK(decided.at(predicate::orientation, tier::semi_static) == 1);
  CHECK(decided.at(predicate::edge_test, tier::semi_static) == 1);
  CHECK(decided.at(predicate::edge_test, tier::interval) == 0);
  CHECK(decided.at(predicate::edge_test, tier::exact) == 0);
}

TEST_CASE("collinear points that doubles cannot tell are the exact tier's", "[tiers]") {
  tier_counters decided;
  const filtered_kernel kernel(decided);
  const double third = 1.0 / 3;
  CHECK(kernel.orientation({0, 0}, {third, third}, {0.1, std::nextafter(0.1, 1)}) ==
        sign::positive);
  CHECK(kernel.orientation({0.1, 0.1}, {0.7, 0.7}, {0.3, 0.3}) == sign::zero);
  CHECK(decided.at(predicate::orientation, tier::exact) >= 1);
}

TEST_CASE("a tie of four different metrics is the exact tier's and goes to one diagonal",
          "[tiers][ties]") {
  tier_counters decided;
  const filtered_kernel kernel(decided);
  const site a = swirl_site(0.5, 0.5), b = swirl_site(-0.5, 0.5), c = swirl_site(-0.5, -0.5),
             d = swirl_site(0.5, -0.5);
  CHECK_FALSE(kernel.insertion_test(a, c, b, d));
  CHECK_FALSE(kernel.insertion_test(b, d, a, c));
  const bool ac = kernel.edge_test(a, c, b, d), bd = kernel.edge_test(b, d, a, c);
  CHECK(ac != bd);
  CHECK(bd);  // the greatest site, (0.5, 0.5), is no end of this diagonal
  CHECK(kernel.edge_test(c, a, d, b) == ac);
  CHECK(kernel.edge_test(d, b, c, a) == bd);
  CHECK(decided.at(predicate::edge_test, tier::semi_static) == 0);
  CHECK(decided.at(predicate::edge_test, tier::interval) == 0);
}

TEST_CASE("the filters of an edge test leave a tie open, and nothing else to a wrong answer",
          "[tiers][ties]") {
  tier_counters decided;
  const site a = swirl_site(0.5, 0.5), b = swirl_site(-0.5, 0.5), c = swirl_site(-0.5, -0.5),
             d = swirl_site(0.5, -0.5);
  CHECK_FALSE(internal::filtered_edge_test(a, c, b, d, decided).certain());
  CHECK(decided.at(predicate::edge_test, tier::interval) == 1);
  const auto round = [](double x, double y) { return site{{x, y}, round_metric}; };
  CHECK(internal::filtered_edge_test(round(0, 0), round(1, 1), round(1, 0), round(0, 1), decided)
            .certain());
  CHECK(decided.limb_products == 0);
  sequence random{22};
  const exact_kernel exact;
  int certain = 0;
  for (int k = 0; k < 300; ++k) {
    site s[4];
    for (site& one : s) one = swirl_site(random.real(-1, 1), random.real(-1, 1));
    const uncertain_bool answer = internal::filtered_edge_test(s[0], s[1], s[2], s[3], decided);
    if (!answer.certain()) continue;
    ++certain;
    CHECK(answer.value() == exact.edge_test(s[0], s[1], s[2], s[3]));
  }
  CHECK(certain > 290);
}

TEST_CASE("among random smooth metrics few edge tests fall through", "[tiers]") {
  tier_counters decided;
  const filtered_kernel kernel(decided);
  sequence random{20};
  constexpr int asked = 40000;
  for (int k = 0; k < asked; ++k) {
    const double x = random.real(-1, 1), y = random.real(-1, 1);
    site s[4];
    for (site& one : s)
      one = swirl_site(x + 0.05 * random.real(-1, 1), y + 0.05 * random.real(-1, 1));
    kernel.edge_test(s[0], s[1], s[2], s[3]);
  }
  CHECK(static_cast<double>(decided.at(predicate::edge_test, tier::exact)) < 1e-4 * asked);
}

// v, its neighbours x and y and a fourth site w between them, all about one edge apart as v's
// metric measures; the metrics are nearly v's, whatever its condition.
namespace {

struct mesh_like {
  site v, w, x, y;
};

mesh_like draw_mesh_like(double condition, sequence& random) {
  const double angle = 3.2 * random.real(-1, 1), c = std::cos(angle), s = std::sin(angle);
  const double turn_to_x = 3.2 * random.real(-1, 1), to_w = 0.9 + 0.4 * random.real(-1, 1),
               to_y = 0.9 + 0.4 * random.real(-1, 1);
  const double long_axis = 1, short_axis = 1 / std::sqrt(condition);
  const auto at = [&](double length, double direction) {
    const double p = length * std::cos(direction) * long_axis,
                 q = length * std::sin(direction) * short_axis;
    const double e = 1 + 0.05 * random.real(-1, 1), f = condition * (1 + 0.05 * random.real(-1, 1));
    return site{{c * p - s * q, s * p + c * q},
                {c * c * e + s * s * f, c * s * (e - f), s * s * e + c * c * f}};
  };
  return {at(0, 0), at(1.4 + 0.6 * random.real(-1, 1), turn_to_x + to_w),
          at(1 + 0.2 * random.real(-1, 1), turn_to_x),
          at(1 + 0.2 * random.real(-1, 1), turn_to_x + to_w + to_y)};
}

}  // namespace

TEST_CASE("the first tier decides nearly every edge test of a smooth mesh", "[tiers]") {
  for (const double condition : {1.0, 1e4, 1e8, 1e12}) {
    tier_counters decided;
    const filtered_kernel kernel(decided);
    sequence random{21};
    constexpr int asked = 5000;
    int yes = 0;
    for (int k = 0; k < asked; ++k) {
      const mesh_like q = draw_mesh_like(condition, random);
      yes += kernel.edge_test(q.v, q.w, q.x, q.y);
    }
    const auto by = [&](tier t) {
      return static_cast<double>(decided.at(predicate::edge_test, t));
    };
    INFO("condition " << condition << ": " << by(tier::semi_static) << ", " << by(tier::interval)
                      << ", " << by(tier::exact));
    CHECK(by(tier::semi_static) >= 0.999 * asked);
    CHECK(by(tier::exact) < 1e-4 * asked);
    CHECK(yes > 0.2 * asked);
    CHECK(yes < 0.8 * asked);
  }
}

TEST_CASE("a first tier's edge test is the same from v and from w, and right", "[tiers]") {
  const filtered_kernel kernel;
  const interval_kernel interval;
  sequence random{22};
  for (int k = 0; k < 1000; ++k) {
    const auto [v, w, x, y] = draw_mesh_like(100, random);
    const bool answer = kernel.edge_test(v, w, x, y);
    CHECK(kernel.edge_test(w, v, y, x) == answer);
    CHECK(kernel.edge_test(v, w, y, x) == answer);
    CHECK_FALSE(interval.edge_test(v, w, x, y).certainly(!answer));
  }
}

TEST_CASE("in-circle of equal metrics: certain unless cocircular", "[tiers]") {
  const interval_kernel kernel;
  const site v{{0, 0}, round_metric}, w{{1, 1}, round_metric}, x{{1, 0}, round_metric};
  CHECK(kernel.edge_test(v, w, x, {{0, 2}, round_metric}).certainly(true));
  CHECK(kernel.edge_test(v, w, x, {{0.25, 0.5}, round_metric}).certainly(false));
  // Small integers are exact in intervals too: the zero is certain, and the order of sites breaks
  // the tie.
  CHECK(kernel.insertion_test(v, w, x, {{0, 1}, round_metric}).certainly(false));
  CHECK(kernel.edge_test(v, w, x, {{0, 1}, round_metric}).certainly(false));
  CHECK(kernel.edge_test(x, {{0, 1}, round_metric}, v, w).certainly(true));
}

TEST_CASE("in_circle: which tier decides", "[tiers]") {
  tier_counters decided;
  const filtered_kernel kernel(decided);
  const auto decided_by = [&](tier t) { return decided.at(predicate::in_circle, t); };
  const metric_tensor m{2, 0.5, 1};
  const point a{0, 0}, b{1, 0}, c{0, 1};
  CHECK(kernel.in_circle(m, a, b, c, {0.25, 0.25}) == sign::positive);
  CHECK(kernel.in_circle(m, a, c, b, {0.25, 0.25}) == sign::negative);
  CHECK(kernel.in_circle(m, a, b, c, {5, 5}) == sign::negative);
  CHECK(decided_by(tier::semi_static) == 3);
  // A tie, and points one unit inside and outside of the circle: integers of a fixed width decide.
  CHECK(kernel.in_circle(a, b, c, {1, 1}) == sign::zero);
  CHECK(kernel.in_circle(a, b, c, {1, std::nextafter(1, 0)}) == sign::positive);
  CHECK(kernel.in_circle(a, b, c, {1, std::nextafter(1, 2)}) == sign::negative);
  CHECK(decided_by(tier::exact) == 3);
  // Numbers too far apart for a fixed width and for the semi-static tier: intervals decide.
  CHECK(kernel.in_circle({1, 0, 1}, {0x1p-300, 0}, {0x1p300, 0}, {0, 0x1p300},
                         {0x1p299, 0x1p299}) == sign::positive);
  CHECK(decided_by(tier::interval) == 1);
  // Numbers that need integers of any size: three points one bit away from a line.
  CHECK(kernel.in_circle({1, 0, 1}, {0, 0}, {1, 0}, {0x1p-1070, 1}, {1, 1}) == sign::negative);
  CHECK(decided_by(tier::exact) == 4);
}

TEST_CASE("magnitudes beyond the range of intervals fall to exact, not to a wrong sign",
          "[tiers][range]") {
  const exact_kernel exact;
  const filtered_kernel filtered;
  for (const int shift : {-1000, -400, -60, 0, 60, 400, 900}) {
    const auto at = [&](double x, double y) {
      site s = swirl_site(x, y);
      s.position = {std::ldexp(x, shift), std::ldexp(y, shift)};
      return s;
    };
    const site v = at(0.25, 0.5), w = at(-0.25, 0.375), x = at(0.125, -0.25), y = at(0.0625, 1);
    CHECK(filtered.edge_test(v, w, x, y) == exact.edge_test(v, w, x, y));
    CHECK(filtered.edge_test(v, w, x, y) == exact.edge_test(w, v, y, x));
    CHECK(filtered.voronoi_vertex_count(v, w, x) == exact.voronoi_vertex_count(x, v, w));
  }
  // A mixture of magnitudes that no single scaling brings into range.
  const site tiny{{0x1p-1060, 0}, {1, 0, 1}}, huge{{0x1p900, 0}, {1, 0, 0x1p-900}},
      middle{{1, 1}, {1, 0.5, 1}}, other{{-1, 3}, {2, 0.5, 1}};
  CHECK(filtered.edge_test(tiny, middle, huge, other) ==
        exact.edge_test(middle, tiny, other, huge));
}

TEST_CASE("a double kernel is wrong where the others are not", "[double_kernel]") {
  const double_kernel plain;
  const exact_kernel exact;
  int wrong = 0;
  const double ulp = 0x1p-53;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const point p{0.5 + i * ulp, 0.5 + j * ulp};
      wrong += plain.orientation(p, {12, 12}, {24, 24}) != exact.orientation(p, {12, 12}, {24, 24});
    }
  CHECK(wrong > 100);
}
