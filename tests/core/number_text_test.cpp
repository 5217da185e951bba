// SPDX-License-Identifier: MIT
//
// parse_number against the C library's strtod (in the "C" locale, correctly rounded in glibc).
#include "asterism/core/number_text.hpp"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "asterism/core/random.hpp"

namespace asterism {
using namespace internal;
namespace {

struct generator : splitmix64 {
  using splitmix64::splitmix64;
  int below(int n) { return integer(0, n - 1); }
};

std::string digits(generator& random, const char* alphabet, int base, int most) {
  std::string text;
  for (int n = random.below(most); n >= 0; --n) text += alphabet[random.below(base)];
  return text;
}

// Draws numbers of any magnitude, some out of range, and some exactly between two doubles.
std::string random_number(generator& random) {
  const bool hexadecimal = random.below(2) == 1;
  std::string text = random.below(2) == 1 ? "-" : "";
  if (hexadecimal) text += "0x";
  const int base = hexadecimal ? 16 : 10;
  text += digits(random, "0123456789abcdef", base, 25);
  if (random.below(2) == 1) text += '.' + digits(random, "0123456789abcdef", base, 25);
  const int largest = hexadecimal ? 1150 : 350;
  if (random.below(4) != 0)
    text += (hexadecimal ? 'p' : 'e') + std::to_string(random.below(2 * largest) - largest);
  return text;
}

void require_same(const std::string& text) {
  INFO(text);
  const double expected = std::strtod(text.c_str(), nullptr);
  const auto found = parse_number(text);
  REQUIRE(found.ok() == std::isfinite(expected));
  if (found.ok())
    REQUIRE(std::bit_cast<std::uint64_t>(found.value()) == std::bit_cast<std::uint64_t>(expected));
}

}  // namespace

TEST_CASE("numbers of any magnitude are read as the nearest double", "[parse_number]") {
  generator random(1);
  for (int i = 0; i < 100000; ++i) require_same(random_number(random));
}

TEST_CASE("every finite double is read back from decimal and hexadecimal", "[parse_number]") {
  generator random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random.bits());
    if (!std::isfinite(value)) continue;
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", value);
    require_same(text);
    std::snprintf(text, sizeof text, "%a", value);
    require_same(text);
  }
}

TEST_CASE("halves round to even, and the borders of the range are exact", "[parse_number]") {
  for (const char* text : {"0x1.00000000000008p0",
                           "0x1.00000000000018p0",
                           "0x1.000000000000080000001p0",
                           "9007199254740993",
                           "9007199254740993.000000000000000000000000000000000001",
                           "1.7976931348623158e308",
                           "1.7976931348623159e308",
                           "0x1.fffffffffffff7fffp1023",
                           "0x1.fffffffffffff8p1023",
                           "0x1p-1074",
                           "0x1p-1075",
                           "0x1.0000000001p-1075",
                           "0x1p-1080",
                           "2.4703282292062327e-324",
                           "2.4703282292062328e-324",
                           "1e99999999999999999999",
                           "-1e-99999999999999999999",
                           "0e99999999999999999999",
                           "0x1p99999999999999999999",
                           "0x1p9223372036854775807",
                           "-0x1p-9223372036854775807"})
    require_same(text);
}

TEST_CASE("what is no finite number is refused and quoted", "[parse_number]") {
  for (const char* text :
       {"",    "-",     "+",     ".",    "e5",    "1e",       "1e+",      "1e5x", "0x",
        "0xg", "0x.p1", "0xinf", "0x-1", "--1",   "+-1",      "1,5",      "1_0",  "1 2",
        "1d3", "nan",   "inf",   "-inf", "1e400", "0x1p1024", "infinity", "١"})
    CHECK_FALSE(parse_number(text).ok());
  CHECK(parse_number("1,5").failure().message == "'1,5' is not a number");
  CHECK(parse_number("-nan").failure().message == "'-nan' is not finite");
  CHECK(parse_number("1,5").failure().code == error_code::bad_number);
  CHECK(quoted_token(std::string(1000, 'x')).size() < 60);
  CHECK(quoted_token("a\nb\x01") == "'a?b?'");
}

TEST_CASE("the shortest decimal of a double is read back as it") {
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(20) == "20");
  CHECK(number_text(1e300) == "1e+300");
  generator random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random.bits());
    if (!std::isfinite(value)) continue;
    const auto read = parse_number(number_text(value));
    REQUIRE(read);
    CHECK(std::bit_cast<std::uint64_t>(read.value()) == std::bit_cast<std::uint64_t>(value));
  }
}

TEST_CASE("two numbers that differ never look alike") {
  using both = std::array<std::string, 2>;
  CHECK(numbers_apart(0.1, 0.25) == both{"0.1", "0.25"});
  CHECK(numbers_apart(1 / 3.0, 1 / 3.0) == both{"0.333333", "0.333333"});
  CHECK(numbers_apart(1, 1.0000001) == both{"1", "1.0000001"});
}

TEST_CASE("numbers in messages have six significant digits, as printf writes them") {
  generator random(4);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random.bits());
    if (!std::isfinite(value)) continue;
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    REQUIRE(format_number(value) == text);
  }
  CHECK(format_number(0.75) == "0.75");
  CHECK(format_number(1e150) == "1e+150");
}

}  // namespace asterism
