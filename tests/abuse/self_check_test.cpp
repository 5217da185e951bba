// SPDX-License-Identifier: MIT
//
// The shadowed interval itself, in every build: it encloses what rounded_interval does, on points,
// boxes and square roots, and says nothing where an end is infinite.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/core/shadowed_interval.hpp"
#include "asterism/tests/property/random_source.hpp"

namespace asterism {
using namespace internal;
namespace {

using property::random_source;
using number = shadowed_interval;

number draw(random_source& random) {
  const double a = random.chance(3) ? random.integer(-4, 4) : random.real(-2, 2);
  if (random.chance(2)) return number(a);
  return number(a, a + (random.chance(2) ? 1 : 0x1p-52));
}

// Chains operations, each of which checks itself.
[[gnu::noinline]] double chain(random_source& random) {
  number x = draw(random);
  for (int step = 0; step < 12; ++step) {
    const number y = draw(random);
    switch (random.integer(0, 5)) {
      case 0:
        x = x + y;
        break;
      case 1:
        x = x - y;
        break;
      case 2:
        x = x * y;
        break;
      case 3:
        x = squared(x);
        break;
      case 4:
        x = -x;
        break;
      default:
        if (x.sup() < 0) break;
        x = root_of_non_negative(x);
    }
    if (x.sup() > 1e100) x = y;
  }
  return x.sup() - x.inf();
}

TEST_CASE("shadows stay inside through chains of operations", "[self-check]") {
  const floating_point_scope scope(rounding::upward);
  random_source random(5);
  for (int i = 0; i < 3000; ++i) CHECK(chain(random) >= 0);
}

TEST_CASE("intervals with an infinite end promise nothing", "[self-check]") {
  const floating_point_scope scope(rounding::upward);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const number large(std::numeric_limits<double>::max());
  const number overflown = large * large;
  CHECK(overflown.sup() == infinity);
  CHECK((number(0, infinity) * number(0) + large).sup() > 0);
  CHECK((overflown - overflown).inf() <= 0);
}

TEST_CASE("square roots, exact and not", "[self-check]") {
  const floating_point_scope scope(rounding::upward);
  CHECK(root_of_non_negative(number(4)).inf() == 2);
  CHECK(root_of_non_negative(number(4)).sup() == 2);
  CHECK(root_of_non_negative(number(-1, 4)).inf() == 0);
  const number two = squared(root_of_non_negative(number(2)));
  CHECK((two.inf() < 2 && two.sup() > 2));
  CHECK(root_of_non_negative(number(0x1p-1074)).inf() == 0x1p-537);
}

}  // namespace
}  // namespace asterism
