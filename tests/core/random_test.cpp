// SPDX-License-Identifier: MIT
#include "asterism/core/random.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

using namespace asterism::internal;

TEST_CASE("the generator is splitmix64, from its state to its bits") {
  // The sequence of the algorithm's published C code for this seed.
  splitmix64 random(1234567);
  CHECK(random.bits() == 6457827717110365317U);
  CHECK(random.bits() == 3203168211198807973U);
  CHECK(random.bits() == 9817491932198370423U);
  splitmix64 again(random.state());
  CHECK(again.bits() == random.bits());
}

TEST_CASE("fractions are in [0, 1) and integers have both ends") {
  CHECK(unit_fraction(0) == 0);
  CHECK(unit_fraction(~std::uint64_t{0}) == 1 - 0x1p-53);
  splitmix64 random(5);
  bool low = false, high = false;
  for (int i = 0; i < 1000; ++i) {
    const int drawn = random.integer(-2, 2);
    REQUIRE((drawn >= -2 && drawn <= 2));
    low = low || drawn == -2;
    high = high || drawn == 2;
    const double part = fraction_of(7, static_cast<std::uint64_t>(i));
    REQUIRE((part >= 0 && part < 1));
  }
  CHECK((low && high));
}
