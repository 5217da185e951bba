// SPDX-License-Identifier: MIT
//
// Tests interval arithmetic against exact numbers: every operation encloses the exact result, and
// no double would be a sharper end. Ends include zeros of both signs, subnormals, the largest
// doubles and infinities.
#include "asterism/core/rounded_interval.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/floating_point_environment.hpp"
#include "asterism/tests/property/random_source.hpp"

namespace asterism {
using namespace internal;
namespace {

using property::random_source;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double subnormal = std::numeric_limits<double>::denorm_min();

double draw_end(random_source& random) {
  static const std::vector<double> special = {
      0.0,       -0.0,    1.0,      -1.0,        subnormal, -subnormal, 3 * subnormal,
      0x1p-1022, largest, -largest, 0x1p-537,    0x1p512,   -0x1p512,   0.1,
      -0.1,      3.0,     -7.0,     0x1.8p-1040, 0x1p-511,  0x1p-540};
  if (random.chance(2)) return special[static_cast<std::size_t>(random.integer(0, 19))];
  const double mantissa = random.real(-1, 1);
  return std::ldexp(mantissa, random.integer(-60, 60));
}

struct ends {
  double low, high;
  rounded_interval box() const { return {low, high}; }
};

ends draw(random_source& random) {
  const double a = draw_end(random), b = random.chance(3) ? a : draw_end(random);
  return a <= b ? ends{a, b} : ends{b, a};
}

// True if `end` is the greatest double not above x, minus infinity where no finite one is.
bool is_rounded_down(double end, const dyadic& x) {
  if (end == -infinity) return x < dyadic(-largest);
  if (x < dyadic(end)) return false;
  return end == largest || x < dyadic(std::nextafter(end, infinity));
}

bool is_rounded_up(double end, const dyadic& x) { return is_rounded_down(-end, -x); }

const dyadic& least(const dyadic& a, const dyadic& b) { return b < a ? b : a; }
const dyadic& greatest(const dyadic& a, const dyadic& b) { return a < b ? b : a; }

// These functions are not inlined into the one that sets the rounding mode, so that no operation
// moves across the change.
[[gnu::noinline]] rounded_interval sum(const ends& a, const ends& b) { return a.box() + b.box(); }
[[gnu::noinline]] rounded_interval difference(const ends& a, const ends& b) {
  return a.box() - b.box();
}
[[gnu::noinline]] rounded_interval product(const ends& a, const ends& b) {
  return a.box() * b.box();
}
[[gnu::noinline]] rounded_interval square(const ends& a) { return squared(a.box()); }
[[gnu::noinline]] rounded_interval root(const ends& a) { return root_of_non_negative(a.box()); }

void check(const rounded_interval& result, const dyadic& low, const dyadic& high) {
  CHECK(is_rounded_down(result.inf(), low));
  CHECK(is_rounded_up(result.sup(), high));
}

void check_operations(const ends& a, const ends& b) {
  const dyadic al(a.low), ah(a.high), bl(b.low), bh(b.high);
  CAPTURE(a.low, a.high, b.low, b.high);
  check(sum(a, b), al + bl, ah + bh);
  check(difference(a, b), al - bh, ah - bl);
  const dyadic p = al * bl, q = al * bh, r = ah * bl, s = ah * bh;
  check(product(a, b), least(least(p, q), least(r, s)), greatest(greatest(p, q), greatest(r, s)));
  const bool straddles = a.low <= 0 && a.high >= 0;
  check(square(a), straddles ? dyadic(0) : least(al * al, ah * ah), greatest(al * al, ah * ah));
}

// Compares the ends of a root by their squares: root <= end if root >= 0 and root squared is no
// more than the end's square.
void check_root(const ends& a) {
  if (a.high < 0) return;
  CAPTURE(a.low, a.high);
  const rounded_interval found = root(a);
  const double low = found.inf(), high = found.sup();
  const dyadic radicand_low(a.low > 0 ? a.low : 0.0), radicand_high(a.high);
  const auto squared_exactly = [](double x) { return dyadic(x) * dyadic(x); };
  CHECK(low >= 0);
  CHECK_FALSE(radicand_low < squared_exactly(low));
  CHECK(radicand_low < squared_exactly(std::nextafter(low, infinity)));
  CHECK_FALSE(squared_exactly(high) < radicand_high);
  if (high > 0) CHECK(squared_exactly(std::nextafter(high, 0.0)) < radicand_high);
}

TEST_CASE("each end of an interval operation is the exact one, rounded outward", "[interval]") {
  const floating_point_scope scope(rounding::upward);
  random_source random(11);
  for (int i = 0; i < 4000; ++i) {
    const ends a = draw(random), b = draw(random);
    check_operations(a, b);
    check_root(a);
  }
}

TEST_CASE("the square root of a square is a point", "[interval]") {
  const floating_point_scope scope(rounding::upward);
  for (const double x : {0.0, 1.0, 3.0, 0x1.8p-500, 0x1p511, 1e7}) {
    const rounded_interval found = root({x * x, x * x});
    CHECK(found.inf() == x);
    CHECK(found.sup() == x);
  }
}

// An infinite end means "no bound": the result encloses that of any number beyond it.
TEST_CASE("an end without bound gives no NaN and loses nothing", "[interval]") {
  const floating_point_scope scope(rounding::upward);
  const std::vector<double> lows = {-infinity, -2, -0.0, 0, 3}, highs = {-2, -0.0, 0, 3, infinity};
  const auto stand_in = [](double x) { return x == infinity ? 1e9 : x == -infinity ? -1e9 : x; };
  const auto encloses = [](const rounded_interval& outer, const rounded_interval& inner) {
    return outer.inf() <= inner.inf() && inner.sup() <= outer.sup();  // false for a NaN
  };
  for (const double al : lows)
    for (const double ah : highs)
      for (const double bl : lows)
        for (const double bh : highs) {
          if (al > ah || bl > bh) continue;
          const ends a{al, ah}, b{bl, bh}, c{stand_in(al), stand_in(ah)},
              d{stand_in(bl), stand_in(bh)};
          CAPTURE(al, ah, bl, bh);
          CHECK(encloses(sum(a, b), sum(c, d)));
          CHECK(encloses(difference(a, b), difference(c, d)));
          CHECK(encloses(product(a, b), product(c, d)));
          CHECK(encloses(square(a), square(c)));
          if (ah >= 0) CHECK(encloses(root(a), root(c)));
        }
}

TEST_CASE("an overflow opens an interval outward alone", "[interval]") {
  const floating_point_scope scope(rounding::upward);
  const rounded_interval up = product({largest, largest}, {2, 2});
  CHECK(up.inf() == largest);
  CHECK(up.sup() == infinity);
  const rounded_interval down = sum({-largest, -largest}, {-largest, -largest});
  CHECK(down.inf() == -infinity);
  CHECK(down.sup() == -largest);
}

}  // namespace
}  // namespace asterism
