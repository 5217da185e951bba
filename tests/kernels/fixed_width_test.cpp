// SPDX-License-Identifier: MIT
//
// Compares the predicates in integers of a fixed width with the same formulas in integers of any
// size: on ties, one unit from them, at the limits of every width, and where the numbers do not
// fit, which must be reported.
#include "asterism/kernels/fixed_width.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <cstdint>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/random.hpp"
#include "asterism/kernels/filtered_kernel.hpp"
#include "asterism/predicates/compare_distance.hpp"
#include "asterism/predicates/domination.hpp"
#include "asterism/predicates/in_circle.hpp"
#include "asterism/predicates/insertion_test.hpp"
#include "asterism/predicates/orientation.hpp"
#include "asterism/predicates/positive_definite.hpp"
#include "asterism/predicates/tie_breaking.hpp"
#include "asterism/predicates/wedge.hpp"

using namespace asterism;
using namespace asterism::internal;

namespace {

struct sequence : splitmix64 {
  using splitmix64::splitmix64;
  int below(int n) { return integer(0, n - 1); }
};

enum class kind { grid, few_bits, full, largest, huge, tiny, far_off, mixed };
constexpr int kinds = 8;

double draw_coordinate(kind which, sequence& random) {
  const double x = random.real(-1, 1);
  switch (which) {
    case kind::grid:
      return random.below(9) - 4;
    case kind::few_bits:
      return std::ldexp(random.below(1 << 21) - (1 << 20), -20);
    case kind::largest:  // all bits set, exponent 0 or -8
      return std::ldexp(random.below(2) != 0 ? 0x1.fffffffffffffp0 : -0x1.fffffffffffffp0,
                        -8 * random.below(2));
    case kind::huge:
      return std::ldexp(x, 1020);
    case kind::tiny:
      return std::ldexp(x, -1060);
    case kind::far_off:
      return 1e8 + 1e-6 * x;
    case kind::mixed:
      return std::ldexp(x, random.below(200) - 100);
    default:
      return x;
  }
}

metric_tensor draw_metric(kind which, sequence& random) {
  if (which == kind::largest)
    return {0x1.fffffffffffffp0, (random.below(2) != 0 ? 1 : -1) * 0x1.ffffffffffffep0,
            0x1.fffffffffffffp0};
  if (which == kind::grid) {
    const double m11 = 2 + random.below(3), m12 = random.below(3) - 1, m22 = 2 + random.below(3);
    return {m11, m12, m22};
  }
  const double a = random.real(-1, 1), b = random.real(-1, 1);
  const metric_tensor m = {1 + 12 * a * a, 12 * a * b, 1 + 12 * b * b};
  if (which != kind::mixed) return m;
  const int e = random.below(100) - 50;
  return {std::ldexp(m.m11, e), std::ldexp(m.m12, e), std::ldexp(m.m22, e)};
}

using four_sites = std::array<site, 4>;

four_sites draw(sequence& random) {
  const auto which = static_cast<kind>(random.below(kinds));
  four_sites s;
  const metric_tensor shared = draw_metric(which, random);
  const bool equal = random.below(3) == 0;
  for (site& one : s)
    one = {{draw_coordinate(which, random), draw_coordinate(which, random)},
           equal ? shared : draw_metric(which, random)};
  // Points on a line, on a parallelogram (cocircular in some metric), and one unit from either.
  const auto &p = s[0].position, &q = s[1].position, &r = s[2].position;
  if (random.below(4) == 0) s[2].position = {p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
  if (random.below(3) == 0) s[3].position = {p.x + q.x - r.x, p.y + q.y - r.y};
  if (random.below(3) == 0) s[3].position.x = std::nextafter(s[3].position.x, 9);
  return s;
}

bool distinct(const four_sites& s) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (s[i].position == s[j].position) return false;
  return true;
}

// Checks that every certain answer is right, and counts them.
struct tally {
  int asked = 0, certain = 0;
  template <class Answer>
  void check(uncertain<Answer> found, uncertain<Answer> expected) {
    ++asked;
    if (!found.certain()) return;
    ++certain;
    REQUIRE(found.value() == expected.value());
  }
};

void check_all(const four_sites& s, tally& count) {
  const auto e0 = convert<dyadic>(s[0]), e1 = convert<dyadic>(s[1]), e2 = convert<dyadic>(s[2]),
             e3 = convert<dyadic>(s[3]);
  const point &p = s[0].position, &q = s[1].position, &r = s[2].position;
  count.check(fixed_width::orientation(p, q, r),
              orientation(e0.position, e1.position, e2.position));
  count.check(fixed_width::is_positive_definite(s[0].metric), is_positive_definite(e0.metric));
  count.check(fixed_width::compare_distance(s[0], s[1], r), compare_distance(e0, e1, e2.position));
  count.check(fixed_width::in_wedge(s[0], s[1], r), in_wedge(e0, e1, e2.position));
  count.check(fixed_width::in_circle(s[0].metric, p, q, r, s[3].position),
              in_circle(e0.metric, e0.position, e1.position, e2.position, e3.position));
  if (!distinct(s)) return;
  count.check(fixed_width::dominates(s[0], s[1], r), dominates(e0, e1, e2.position));
  four_sites same = s;
  for (site& one : same) one.metric = s[0].metric;
  const auto expected = [&](bool tie) {
    return insertion_test_equal_metrics(e0.metric, e0.position, e1.position, e2.position,
                                        e3.position, [&] { return uncertain_bool(tie); });
  };
  count.check(fixed_width::insertion_test_equal_metrics(same[0], same[1], same[2], same[3]),
              expected(false));
  count.check(fixed_width::edge_test_equal_metrics(same[0], same[1], same[2], same[3]),
              expected(equal_metric_tie_goes_to_edge(p, q, r, s[3].position)));
}

}  // namespace

TEST_CASE("fixed widths answer as numbers of any size do", "[fixed_width]") {
  sequence random{11};
  tally count;
  for (int round = 0; round < 20000; ++round) {
    CAPTURE(round);
    check_all(draw(random), count);
  }
  CHECK(count.certain > count.asked / 2);
}

TEST_CASE("fixed widths answer the same in every rounding mode", "[fixed_width]") {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    sequence random{12};
    std::array<uncertain_sign, 2> found;
    for (int round = 0; round < 200; ++round) {
      const four_sites s = draw(random);
      for (const int set : {FE_TONEAREST, mode}) {
        std::fesetround(set);
        found[set == mode] = fixed_width::compare_distance(s[0], s[1], s[2].position);
        std::fesetround(FE_TONEAREST);
      }
      CHECK(found[0].certain() == found[1].certain());
      if (found[0].certain() && found[1].certain()) CHECK(found[0].value() == found[1].value());
    }
  }
}

TEST_CASE("numbers that no common unit holds are undecided", "[fixed_width]") {
  const point origin{0, 0}, right{1, 0};
  // 2^-61 of the largest is the last unit: below it a bit is lost.
  CHECK(fixed_width::orientation(origin, right, {0, 0x1p-60}).certainly(sign::positive));
  CHECK_FALSE(fixed_width::orientation(origin, right, {0, 0x1p-61}).certain());
  CHECK_FALSE(fixed_width::orientation(origin, right, {0, 0x1p-1074}).certain());
  CHECK(fixed_width::orientation(origin, {0x1p-1070, 0}, {0, 0x1p-1074}).certainly(sign::positive));
  CHECK_FALSE(fixed_width::is_positive_definite({1, 0, 0x1p-61}).certain());
  const site v{origin, {1, 0, 1}}, w{{2, 0}, {1, 0, 0x1p-61}};
  CHECK_FALSE(fixed_width::compare_distance(v, w, right).certain());
}

TEST_CASE("a tie of equal metrics is decided in fixed widths", "[fixed_width][ties]") {
  const metric_tensor round{1, 0, 1};
  const double u = 0x1p-20;
  const site v{{0.6, 0.8}, round}, w{{-0.6, -0.8}, round}, x{{0.8, -0.6}, round},
      y{{-0.8, 0.6}, round};
  CHECK(fixed_width::insertion_test_equal_metrics(v, w, x, y).certainly(false));
  CHECK(fixed_width::edge_test_equal_metrics(v, w, x, y).certainly(true));
  CHECK(fixed_width::edge_test_equal_metrics(x, y, v, w).certainly(false));
  // Asks about points off the line of two sites, between the two, and on the line outside.
  const site a{{0, 0}, round}, b{{3 * u, 3 * u}, round}, between{{u, u}, round},
      beyond{{4 * u, 4 * u}, round}, aside{{0, u}, round};
  CHECK(fixed_width::edge_test_equal_metrics(a, b, between, aside).certainly(false));
  CHECK(fixed_width::edge_test_equal_metrics(a, b, aside, beyond).certainly(true));
}

// Rounding toward zero turns an overflow into the largest double. An infinity would be noticed, and
// this is not.
TEST_CASE("differences that overflow are not decided by doubles in any rounding mode",
          "[fixed_width][filter]") {
  const double big = 0x1.8p1023;
  tier_counters decided;
  const filtered_kernel kernel(decided);
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    // The differences are (2 big, 3) and (big, 2), of determinant big. With 2 big clipped to the
    // largest double, 4/3 big, it would be negative.
    const sign s = kernel.orientation({-big, 0}, {big, 3}, {0, 2});
    std::fesetround(FE_TONEAREST);
    CHECK(s == sign::positive);
    CHECK(decided.at(predicate::orientation, tier::semi_static) == 0);
  }
}
