// SPDX-License-Identifier: MIT
//
// Reads hexadecimal doubles, such as 1.8p-3 for 0.1875, without the standard library.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace asterism::internal {

// Digits of a hexadecimal number: bits 2^power, and whether a later digit was not zero.
struct hexadecimal_digits {
  std::uint64_t bits = 0;
  long long power = 0;
  bool has_more = false, has_any = false;
};

inline int hexadecimal_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Reads digits with at most one point, and moves `at` beyond them.
inline hexadecimal_digits read_digits(const char*& at, const char* last) {
  hexadecimal_digits read;
  bool is_after_point = false;
  for (; at != last; ++at) {
    if (*at == '.' && !is_after_point) {
      is_after_point = true;
      continue;
    }
    const int digit = hexadecimal_digit(*at);
    if (digit < 0) break;
    read.has_any = true;
    const bool fits = read.bits >> 60 == 0;
    if (fits) read.bits = 16 * read.bits + static_cast<std::uint64_t>(digit);
    if (!fits) read.has_more = read.has_more || digit != 0;
    if (fits && is_after_point) read.power -= 4;
    if (!fits && !is_after_point) read.power += 4;
  }
  return read;
}

// Reads "p-12", and moves `at` beyond it; 0 where there is none. Stops at 2^60, for which no number
// of digits compensates.
inline long long read_power(const char*& at, const char* last) {
  constexpr long long beyond_any_text = 1LL << 60;
  if (at == last || (*at != 'p' && *at != 'P')) return 0;
  const char* digits = at + 1;
  if (digits != last && *digits == '+') {
    ++digits;
    if (digits != last && *digits == '-') return 0;
  }
  long long power = 0;
  const auto read = std::from_chars(digits, last, power);
  if (read.ec == std::errc::invalid_argument) return 0;
  at = read.ptr;
  if (read.ec == std::errc() && power > -beyond_any_text && power < beyond_any_text) return power;
  return *digits == '-' ? -beyond_any_text : beyond_any_text;
}

// Returns the double nearest to what was read, ties to even; infinite beyond all.
inline double nearest_double(hexadecimal_digits read) {
  if (read.bits == 0) return 0;
  const int unused = std::countl_zero(read.bits);
  const std::uint64_t bits = read.bits << unused;  // the first bit is one: 2^63 times its worth
  const long long lowest = read.power - unused, highest = lowest + 63;
  if (highest > 1023) return HUGE_VAL;
  // Keeps the leading 53 bits of the number; of a subnormal one the bits worth 2^-1074 or more.
  const long long dropped = highest < -1022 ? -1074 - lowest : 11;
  if (dropped > 64) return 0;
  const auto count = static_cast<int>(dropped);
  const std::uint64_t kept = count == 64 ? 0 : bits >> count,
                      half = std::uint64_t{1} << (count - 1);
  const std::uint64_t rest = bits - (count == 64 ? 0 : kept << count);
  const bool is_tie = rest == half && !read.has_more;
  const bool goes_up = is_tie ? kept % 2 == 1 : rest >= half;
  const auto rounded = static_cast<double>(kept + (goes_up ? 1 : 0));
  return std::ldexp(rounded, static_cast<int>(lowest + dropped));
}

// Reads as std::from_chars does with std::chars_format::hex, but no infinity. A number beyond all
// doubles is out of range; one that is too small is zero.
inline std::from_chars_result read_hexadecimal(const char* first, const char* last, double& value) {
  const char* at = first;
  const bool is_negative = at != last && *at == '-';
  if (is_negative) ++at;
  hexadecimal_digits read = read_digits(at, last);
  if (!read.has_any) return {first, std::errc::invalid_argument};
  read.power += read_power(at, last);
  const double nearest = nearest_double(read);
  if (!std::isfinite(nearest)) return {at, std::errc::result_out_of_range};
  value = is_negative ? -nearest : nearest;
  return {at, std::errc()};
}

}  // namespace asterism::internal
