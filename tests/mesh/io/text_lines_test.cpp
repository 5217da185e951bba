// SPDX-License-Identifier: MIT
//
// Numbers that are written are read back bit by bit, and no shorter text would be.
#include "asterism/mesh/io/text_lines.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#include "../../../packages/npm/shortest_text.hpp"
#include "asterism/core/number_text.hpp"
#include "asterism/core/random.hpp"

namespace {

std::string written(double x) {
  std::string text;
  asterism::internal::append_number(text, x);
  return text;
}

int digits_of(const std::string& text) {
  const std::string mantissa = text.substr(0, text.find('e'));
  std::string digits;
  for (const char c : mantissa)
    if (c >= '0' && c <= '9') digits += c;
  const std::size_t first = digits.find_first_not_of('0'), last = digits.find_last_not_of('0');
  return first == std::string::npos ? 1 : static_cast<int>(last - first) + 1;
}

// Requires that the stand-in for std::to_chars writes what std::to_chars writes.
void hold_stand_in(double x) {
  if (asterism::internal::shortest_text(x) == written(x)) return;
  INFO(asterism::internal::shortest_text(x) << " where " << written(x) << " is wanted");
  REQUIRE(false);
}

// Reads by two routes: the project's and the C library's.
void hold(double x) {
  const std::string text = written(x);
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto read = asterism::internal::parse_number(text);
  const double other = std::strtod(text.c_str(), nullptr);
  if (read && std::bit_cast<std::uint64_t>(read.value()) == bits &&
      std::bit_cast<std::uint64_t>(other) == bits)
    return;
  INFO(text << " of the bits " << std::hex << bits);
  REQUIRE(false);
}

// Any shorter decimal that reads back the same would be the nearest one with as many digits. Powers
// of two are an exception: their neighbour below is nearer than the one above. All digits of an
// integer are written unless an exponent is shorter.
void hold_shortest(double x) {
  const std::string shown = written(x);
  const int digits = digits_of(shown);
  if (digits == 1) return;
  char text[40];
  (void)std::snprintf(text, sizeof text, "%.*e", digits - 2, x);
  if (std::strtod(text, nullptr) != x) return;
  if (shown.find_first_of(".e") == std::string::npos && shown.size() <= std::strlen(text)) return;
  INFO(shown << " is longer than " << text);
  REQUIRE(false);
}

}  // namespace

TEST_CASE("numbers written are short") {
  CHECK(written(0.1) == "0.1");
  CHECK(written(-0.0) == "-0");
  CHECK(written(1.0 / 3) == "0.3333333333333333");
  CHECK(written(0.1 + 0.2) == "0.30000000000000004");
  CHECK(written(5e-324) == "5e-324");
  CHECK(written(123456) == "123456");
}

TEST_CASE("numbers written are read back bit by bit") {
  asterism::internal::splitmix64 random(41);
  constexpr int rounds = 200000, checked_for_length = 20;
  for (int i = 0; i < rounds; ++i) {
    const std::uint64_t bits = random.bits();
    const double any = std::bit_cast<double>(bits);
    const double subnormal = std::bit_cast<double>(bits & 0x800fffffffffffffU);
    for (const double x :
         {any, subnormal, random.real(-1, 1), std::floor(random.real(0, 0x1p60))}) {
      if (!std::isfinite(x)) continue;
      hold(x);
      if (i % checked_for_length != 0) continue;
      hold_shortest(x);
      hold_stand_in(x);
    }
  }
  for (int n = -1074; n <= 1023; ++n) {
    const double power = std::ldexp(1.0, n);
    for (const double x : {std::nextafter(power, 0.0), power, std::nextafter(power, 2 * power)})
      if (std::isfinite(x)) {
        hold(x);
        hold_stand_in(x);
      }
  }
}
