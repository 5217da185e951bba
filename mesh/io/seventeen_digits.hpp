// SPDX-License-Identifier: MIT
//
// Writes a double with seventeen significant digits, as printf's %.17g does in the C locale,
// several times as fast as the standard library does.
//
// A double of ordinary size is m 2^e with m below 2^53. Its first seventeen digits are m 10^s 2^e
// for an s of at most 21, whose product with m is below 2^123: an integer of 128 bits holds it
// exactly, and shifting it tells exactly on which side of a half the rest is. No other sizes are
// written here.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace asterism::internal {

class seventeen_digits {
 public:
  // Longest text: sign, "0.000", seventeen digits.
  static constexpr std::size_t longest = 24;

  // Writes x from `to` on and returns the end; null, with nothing written, unless x is 0 or its
  // magnitude is at least 1e-4 and rounds to less than 1e17.
  static char* write(char* to, double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const bool negative = bits >> 63 != 0;
    char* const digits_from = to + (negative ? 1 : 0);
    if ((bits << 1) == 0) {
      if (negative) *to = '-';
      *digits_from = '0';
      return digits_from + 1;
    }
    if (x > 0 && x < most_digit) {
      const int digit = static_cast<int>(x);
      if (digit == x) {
        *to = static_cast<char>('0' + digit);
        return to + 1;
      }
    }
    decimal d;
    if (!find(bits & (~std::uint64_t{0} >> 1), d)) return nullptr;
    if (negative) *to = '-';
    return put(digits_from, d);
  }

 private:
  static constexpr int digit_count = 17, most_digit = 10;
  static constexpr std::uint64_t least = 10'000'000'000'000'000U, beyond = 10 * least;

  // The extension's mark goes with a typedef alone.
  __extension__ typedef unsigned __int128 wide;  // NOLINT(modernize-use-using)

  struct decimal {
    std::uint64_t digits = 0;  // seventeen
    int exponent = 0;          // of the first one
  };

  static constexpr wide power_of_ten(int n) {
    wide power = 1;
    for (int i = 0; i < n; ++i) power *= 10;
    return power;
  }
  static constexpr int most_power = 21;
  static constexpr std::array<wide, most_power + 1> powers() {
    std::array<wide, most_power + 1> all{};
    for (int i = 0; i <= most_power; ++i) all[static_cast<std::size_t>(i)] = power_of_ten(i);
    return all;
  }

  // The whole part of m 10^s 2^e, and how the rest compares with a half.
  struct part {
    wide whole = 0;
    int rest = -1;  // -1, 0 or 1
  };
  static part scaled(std::uint64_t m, int e, int s) {
    static constexpr std::array<wide, most_power + 1> ten = powers();
    const wide product = wide{m} * ten[static_cast<std::size_t>(s)];
    if (e >= 0) return {product << e, -1};
    const wide half = wide{1} << (-e - 1), rest = product & (2 * half - 1);
    return {product >> -e, rest < half ? -1 : rest == half ? 0 : 1};
  }

  // Finds the digits of a positive double by its bits; false if it is of another size.
  static bool find(std::uint64_t bits, decimal& d) {
    constexpr int least_exponent = -14, most_exponent = 56;  // 2^-14 < 1e-4, 1e17 < 2^57
    const int biased = static_cast<int>(bits >> 52);
    const int binary = biased - 1023;
    if (binary < least_exponent || binary > most_exponent) return false;
    const std::uint64_t m = (bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1} << 52);
    // The floor of binary times the logarithm of 2, which is the exponent sought or one less.
    int exponent = (binary * 1233) >> 12;
    if (exponent > digit_count - 1) return false;
    part p = scaled(m, binary - 52, digit_count - 1 - exponent);
    if (p.whole >= beyond) {
      if (++exponent > digit_count - 1) return false;
      p = scaled(m, binary - 52, digit_count - 1 - exponent);
    }
    auto digits = static_cast<std::uint64_t>(p.whole);
    if (p.rest > 0 || (p.rest == 0 && (digits & 1U) != 0)) ++digits;
    if (digits == beyond) {
      digits = least;
      ++exponent;
    }
    if (exponent < -4 || exponent > digit_count - 1) return false;
    d = {digits, exponent};
    return true;
  }

  static void put_eight(char* to, std::uint32_t digits) {
    for (int i = 7; i > 0; i -= 2, digits /= 100) {
      const std::uint32_t two = digits % 100;
      to[i] = static_cast<char>('0' + two % 10);
      to[i - 1] = static_cast<char>('0' + two / 10);
    }
  }

  static char* put(char* to, const decimal& d) {
    // The first digit, and twice eight.
    constexpr std::uint64_t half = 100'000'000;
    std::array<char, digit_count> text;
    const std::uint64_t upper = d.digits / half;
    text[0] = static_cast<char>('0' + upper / half);
    put_eight(text.data() + 1, static_cast<std::uint32_t>(upper % half));
    put_eight(text.data() + 9, static_cast<std::uint32_t>(d.digits % half));
    std::size_t count = digit_count;
    while (count > 1 && text[count - 1] == '0') --count;
    std::size_t whole = 0;  // digits before the point
    if (d.exponent < 0) {
      constexpr std::array<char, 5> most_zeros = {'0', '.', '0', '0', '0'};
      std::memcpy(to, most_zeros.data(), most_zeros.size());
      to += 1 - d.exponent;
    } else {
      whole = static_cast<std::size_t>(d.exponent) + 1;
      std::memcpy(to, text.data(), whole);
      to += whole;
      if (count <= whole) return to;
      *to++ = '.';
    }
    std::memcpy(to, text.data() + whole, count - whole);
    return to + (count - whole);
  }
};

}  // namespace asterism::internal
