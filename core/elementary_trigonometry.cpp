// SPDX-License-Identifier: MIT
//
// Computes sines, cosines, tangents and angles, by the methods of elementary.cpp.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "asterism/core/double_pair.hpp"
#include "asterism/core/elementary.hpp"

namespace asterism::internal::elementary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Parts of pi / 2; products with an integer below 2^20 are exact, except for the last part.
constexpr std::array<double, 4> half_pi_parts = {0x1.921fb54400000p+0, 0x1.0b4611a600000p-34,
                                                 0x1.3198a2e000000p-69, 0x1.b839a252049c1p-104};
constexpr double_pair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

// An argument as quarter pi / 2 + rest, |rest| at most about pi / 4; the quarter modulo 4.
struct reduced_angle {
  int quarter = 0;
  double_pair rest;
};

reduced_angle reduced_moderate(double x) {
  const double k = std::round(x * two_over_pi);
  const double_pair first = exact_sum(x - k * half_pi_parts[0], -(k * half_pi_parts[1]));
  const double_pair second = exact_sum(first.head, -(k * half_pi_parts[2]));
  const double tail = (second.tail + first.tail) - k * half_pi_parts[3];
  return {static_cast<int>(static_cast<std::int64_t>(k) & 3),
          exact_sum_of_ordered(second.head, tail)};
}

// Bits of 2 / pi after the point, 64 to a word.
constexpr std::array<std::uint64_t, 19> two_over_pi_bits = {
    0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
    0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484,
    0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d, 0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab};

// Returns 64 bits of 2 / pi that begin `place` bits after the point; zeros before it.
std::uint64_t bits_from(int place) {
  if (place <= -64) return 0;
  if (place < 0) return two_over_pi_bits[0] >> -place;
  const auto word = static_cast<std::size_t>(place / 64);
  const int shift = place % 64;
  const std::uint64_t high = two_over_pi_bits.at(word) << shift;
  return shift == 0 ? high : high | (two_over_pi_bits.at(word + 1) >> (64 - shift));
}

// Reduces by Payne and Hanek's method: of x 2 / pi, an integer times bits of 2 / pi, only the bits
// around the point are needed, two before it and 128 after. Requires |x| >= 2^19.
reduced_angle reduced_huge(double x) {
  int exponent = 0;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const auto integer = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  exponent -= 53;  // |x| = integer 2^exponent
  // Skips the bits of 2 / pi worth more than 2^-(place + 1): they make multiples of 4 of x 2 / pi.
  const int place = exponent - 2;
  __extension__ using wide = unsigned __int128;
  const std::array words = {bits_from(place), bits_from(place + 64), bits_from(place + 128)};
  // Multiplies the integer by the bits of 2 / pi, modulo 4 quarters.
  const wide low = static_cast<wide>(integer) * words[2];
  const wide middle = static_cast<wide>(integer) * words[1] + static_cast<std::uint64_t>(low >> 64);
  const std::uint64_t high = integer * words[0] + static_cast<std::uint64_t>(middle >> 64);
  std::uint64_t after = static_cast<std::uint64_t>(middle), last = static_cast<std::uint64_t>(low);
  int quarter = static_cast<int>(high >> 62);
  // Converts the fraction of the quarter, 190 bits, to a signed one of absolute value at most 1/2.
  std::uint64_t top = (high << 2) | (after >> 62);
  after = (after << 2) | (last >> 62);
  last <<= 2;
  const bool above = (top >> 63) != 0;
  if (above) {
    ++quarter;
    last = ~last;
    after = ~after;
    top = ~top;
  }
  double_pair share = exact_sum(std::ldexp(static_cast<double>(top >> 11), -53),
                                std::ldexp(static_cast<double>(top & 0x7ff), -64));
  const double_pair more =
      exact_sum(share.tail, std::ldexp(static_cast<double>(after >> 11), -117));
  const double_pair sum = exact_sum(share.head, more.head);
  const double finest = std::ldexp(static_cast<double>(after & 0x7ff), -128) +
                        std::ldexp(static_cast<double>(last >> 11), -181);
  share = exact_sum_of_ordered(sum.head, sum.tail + more.tail + finest);
  if (above) share = {-share.head, -share.tail};
  reduced_angle angle{quarter & 3, product(share, half_pi)};
  if (x < 0) angle = {(4 - angle.quarter) & 3, {-angle.rest.head, -angle.rest.tail}};
  return angle;
}

reduced_angle reduced(double x) {
  constexpr double moderate = 0x1p19;
  return std::abs(x) < moderate ? reduced_moderate(x) : reduced_huge(x);
}

// Returns the sine of |x| up to pi / 4; the omitted terms of the series are below 2^-59 of the
// sine.
double_pair sine_of_small(const double_pair& x) {
  static constexpr std::array<double, 8> series = {
      -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
      -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const double square = x.head * x.head;
  const double rest = x.head * square * polynomial(series, square);
  return exact_sum_of_ordered(x.head, rest + x.tail * (1 - square / 2));
}

double_pair cosine_of_small(const double_pair& x) {
  static constexpr std::array<double, 8> series = {
      1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
      1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
  // Ignores a square that underflows: it is far below 1.
  const double_pair square =
      std::abs(x.head) > 0x1p-400 ? exact_product(x.head, x.head) : double_pair{};
  const double_pair first = exact_sum_of_ordered(1, -square.head / 2);
  const double rest = square.head * square.head * polynomial(series, square.head);
  return exact_sum_of_ordered(first.head, first.tail + (rest - square.tail / 2 - x.head * x.tail));
}

double_pair sine_of(const reduced_angle& angle) {
  const double_pair s =
      angle.quarter % 2 == 0 ? sine_of_small(angle.rest) : cosine_of_small(angle.rest);
  return angle.quarter < 2 ? s : double_pair{-s.head, -s.tail};
}

// Values of arctan(k / 8).
constexpr std::array<double_pair, 9> arc_tangents = {{
    {0, 0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
}};

// Returns a + f b as a pair, for f of about an eighth: only the tail of the pair is rounded.
double_pair sum_with_product(double a, double f, double b) {
  const double_pair p = exact_product(f, b), sum = exact_sum(a, p.head);
  return exact_sum_of_ordered(sum.head, sum.tail + p.tail);
}

// Returns arctan(n / d) for 0 <= n <= d, d in [1, 2): arctan(k / 8) for the nearest k, plus the
// series of the difference, whose tangent is at most 1/16 in size.
double_pair arc_tangent_of_share(double n, double d) {
  static constexpr std::array<double, 7> series = {-1.0 / 3,  1.0 / 5,  -1.0 / 7, 1.0 / 9,
                                                   -1.0 / 11, 1.0 / 13, -1.0 / 15};
  const double k = std::round(8 * n / d);
  const double_pair near = arc_tangents.at(static_cast<std::size_t>(k));
  const double_pair t = quotient(sum_with_product(n, -k / 8, d), sum_with_product(d, k / 8, n));
  const double square = t.head * t.head;
  const double rest = t.head * square * polynomial(series, square);
  const double_pair sum = exact_sum(near.head, t.head);
  return exact_sum_of_ordered(sum.head, sum.tail + (near.tail + (t.tail + rest)));
}

// Returns arctan(n / d) for 0 < n <= d.
double_pair arc_tangent_of_quotient(double n, double d) {
  int exponent = 0;
  const double unit = std::frexp(d, &exponent);
  // Returns n / d, which equals its arctangent to all digits where n is far below d. It may be
  // subnormal.
  if (std::ilogb(n) - exponent < -60) return {n / d, 0};
  return arc_tangent_of_share(std::ldexp(n, 1 - exponent), 2 * unit);
}

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return not_a_number;
  if (std::abs(x) < 0x1p-27) return x;  // and -0
  const double_pair s = sine_of(reduced(x));
  return s.head + s.tail;
}

double cos(double x) {
  if (!std::isfinite(x)) return not_a_number;
  reduced_angle angle = reduced(x);
  angle.quarter = (angle.quarter + 1) & 3;
  const double_pair c = sine_of(angle);
  return c.head + c.tail;
}

double tan(double x) {
  if (!std::isfinite(x)) return not_a_number;
  if (std::abs(x) < 0x1p-27) return x;
  reduced_angle angle = reduced(x);
  const double_pair s = sine_of(angle);
  angle.quarter = (angle.quarter + 1) & 3;
  const double_pair t = quotient(s, sine_of(angle));
  return t.head + t.tail;
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  double width = std::abs(x), height = std::abs(y);
  if (width == infinity && height == infinity) width = height = 1;
  double_pair angle{};
  if (height == 0 || width == infinity)
    angle = {};
  else if (width == 0 || height == infinity)
    angle = half_pi;
  else if (height <= width)
    angle = arc_tangent_of_quotient(height, width);
  else {
    const double_pair other = arc_tangent_of_quotient(width, height);
    const double_pair rest = exact_sum(half_pi.head, -other.head);
    angle = exact_sum_of_ordered(rest.head, rest.tail + (half_pi.tail - other.tail));
  }
  if (std::signbit(x)) {
    const double_pair rest = exact_sum(2 * half_pi.head, -angle.head);
    angle = {rest.head, rest.tail + (2 * half_pi.tail - angle.tail)};
  }
  return std::copysign(angle.head + angle.tail, y);
}

}  // namespace asterism::internal::elementary
