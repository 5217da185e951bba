// SPDX-License-Identifier: MIT
//
// Seventeen digits written quickly are those of the standard library.
#include "asterism/mesh/io/seventeen_digits.hpp"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "asterism/core/random.hpp"

using asterism::internal::seventeen_digits;

namespace {

std::string standard(double x) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 17);
  return {text.data(), end.ptr};
}

std::string quick(double x) {
  std::array<char, seventeen_digits::longest> text{};
  char* const end = seventeen_digits::write(text.data(), x);
  return end == nullptr ? std::string() : std::string(text.data(), end);
}

// Counts what was written here; what was not is of another size.
struct comparison {
  std::size_t written = 0;

  void hold(double x) {
    const std::string text = quick(x);
    const bool ordinary = x == 0 || (std::abs(x) >= 1e-4 && std::abs(x) < 99999999999999990.0);
    if (text.empty()) {
      INFO(standard(x));
      REQUIRE_FALSE(ordinary);
      return;
    }
    ++written;
    if (text != standard(x)) REQUIRE(text == standard(x));
  }
  void hold_around(double x) {
    double above = x, below = x;
    for (int i = 0; i < 20; ++i) {
      for (const double y : {above, below, -above, -below}) hold(y);
      above = std::nextafter(above, std::numeric_limits<double>::infinity());
      below = std::nextafter(below, 0.0);
    }
  }
};

}  // namespace

TEST_CASE("seventeen digits are those of the standard library") {
  comparison all;
  for (const double x : {0.0, -0.0, 1.0, 0.1, 0.5, 123.0, 1e16, 9007199254740993.0}) all.hold(x);
  CHECK(quick(-0.0) == "-0");
  CHECK(quick(0.001) == "0.001");
  CHECK(quick(std::numeric_limits<double>::infinity()).empty());
  CHECK(quick(std::numeric_limits<double>::quiet_NaN()).empty());
  CHECK(quick(5e-324).empty());
  for (int n = -8; n <= 20; ++n) all.hold_around(std::pow(10.0, n));
  for (int n = -20; n <= 70; ++n) all.hold_around(std::ldexp(1.0, n));
  asterism::internal::splitmix64 random(41);
  constexpr int rounds = 200000;
  for (int i = 0; i < rounds; ++i) {
    all.hold(random.real(-1, 1));
    all.hold(std::ldexp(random.real(1, 2), static_cast<int>(random.bits() % 76) - 17));
    // Few bits below the point: halves of the last digit are met.
    all.hold(std::ldexp(std::floor(random.real(0, 0x1p53)), -static_cast<int>(random.bits() % 10)));
    all.hold(std::bit_cast<double>(std::uint64_t{random.bits()}));
  }
  CHECK(all.written > 3 * rounds / 2);
}
