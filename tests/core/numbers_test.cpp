// SPDX-License-Identifier: MIT
//
// The exact numbers: against values that can be written down, and against __float128-free integer
// identities.
#include <catch2/catch.hpp>
#include <cfloat>
#include <cmath>
#include <limits>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/interval.hpp"
#include "asterism/core/square_root_sum.hpp"

using namespace asterism;
using namespace asterism::internal;

TEST_CASE("a dyadic number holds every double exactly", "[dyadic]") {
  const double smallest = std::numeric_limits<double>::denorm_min();
  for (const double x : {1.0, -1.0, 0.1, DBL_MAX, DBL_MIN, smallest, 3 * smallest, -0x1.8p-1040}) {
    const dyadic d(x);
    CHECK(d.sign_value() == to_sign((x > 0) - (x < 0)));
    // The mantissa of a double is odd and of one limb. Scaled by the exponent it gives the double
    // again.
    REQUIRE(d.mantissa().limbs().size() == 1);
    const auto size = static_cast<double>(d.mantissa().limbs()[0]);
    CHECK(std::ldexp(x < 0 ? -size : size, static_cast<int>(d.exponent())) == x);
  }
  CHECK(dyadic(0.0).is_zero());
  CHECK(dyadic(-0.0).is_zero());
}

TEST_CASE("dyadic sums keep what doubles drop", "[dyadic]") {
  const dyadic huge(0x1p1000), tiny(0x1p-1000);
  CHECK(((huge + tiny) - huge) == tiny);
  CHECK((huge * tiny) == dyadic(1));
  CHECK((dyadic(0.1) + dyadic(0.2) - dyadic(0.3)).sign_value() == sign::positive);
  CHECK((dyadic(3) - dyadic(3)).is_zero());
  CHECK(dyadic(5).scaled(-1) < dyadic(3));
  CHECK(dyadic(0x1p-30).magnitude() == -29);
}

TEST_CASE("the sign of a + b sqrt c is exact", "[square_root_sum]") {
  const dyadic two(2), four(4), zero(0);
  // 1393 / 985 is a convergent of sqrt 2: 1393^2 - 2 * 985^2 = -1.
  CHECK(square_root_sum(dyadic(-1393), dyadic(985), two).sign_value() == sign::positive);
  CHECK(square_root_sum(dyadic(1393), dyadic(-985), two).sign_value() == sign::negative);
  CHECK(square_root_sum(dyadic(-6), dyadic(3), four).sign_value() == sign::zero);
  CHECK(square_root_sum(dyadic(0), dyadic(-7), zero).sign_value() == sign::zero);
  const square_root_sum root(dyadic(0), dyadic(1), two);
  CHECK((root * root - square_root_sum(2)).sign_value() == sign::zero);
  CHECK((root * root * root - root - root).sign_value() == sign::zero);
}

TEST_CASE("an interval that overflowed or met a NaN is never certain", "[interval]") {
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_FALSE(sign_of(interval(1, infinity)).certain());
  CHECK_FALSE(sign_of(interval(-infinity, -1)).certain());
  CHECK(sign_of(interval(0, 0)).certainly(sign::zero));
  CHECK_FALSE(sign_of(interval(0, 1)).certain());
  CHECK(sign_of(interval(0x1p-1074, 1)).certainly(sign::positive));
}
