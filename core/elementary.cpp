// SPDX-License-Identifier: MIT
//
// Each function reduces its argument, sums a Taylor polynomial for what is left, and adds the
// largest term last with its rounding error: so little but the last rounding is lost. A constant
// with more digits than a double holds is a sum of doubles; the tests compute them again.
#include "asterism/core/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "asterism/core/floating_point_environment.hpp"

namespace asterism::internal::elementary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// head + tail, the tail at most about a unit in the last place of the head.
struct double_pair {
  double head = 0, tail = 0;
};

double_pair exact_sum(double a, double b) {
  const double s = a + b, b_part = s - a, a_part = s - b_part;
  return {s, (a - a_part) + (b - b_part)};
}

// Requires |a| >= |b| or a == 0.
double_pair exact_sum_of_ordered(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

// Requires |a|, |b| below 2^990, and the product away from underflow.
double_pair exact_product(double a, double b) {
  constexpr double splitter = 0x1p27 + 1;
  const double p = a * b;
  const double a_big = a * splitter, a_high = a_big - (a_big - a), a_low = a - a_high;
  const double b_big = b * splitter, b_high = b_big - (b_big - b), b_low = b - b_high;
  return {p, ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

double_pair product(const double_pair& a, const double_pair& b) {
  const double_pair p = exact_product(a.head, b.head);
  return exact_sum_of_ordered(p.head, p.tail + (a.head * b.tail + a.tail * b.head));
}

double_pair quotient(const double_pair& a, const double_pair& b) {
  const double q = a.head / b.head;
  const double_pair back = exact_product(q, b.head);
  return {q, (((a.head - back.head) - back.tail) + a.tail - q * b.tail) / b.head};
}

// Returns coefficients[0] + x coefficients[1] + ...
double polynomial(std::span<const double> coefficients, double x) {
  double sum = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

// ln 2 and its first 38 bits, of which an integer below 2^15 times it is exact; 1 / ln 2.
constexpr double_pair ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr double_pair ln2_short{0x1.62e42fefa0000p-1, 0x1.cf79abc9e3b3ap-40};
constexpr double_pair inverse_ln2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr double_pair inverse_ln10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

struct scaled_number {
  double mantissa = 1;  // in [sqrt(1/2), sqrt(2)]
  int exponent = 0;
};

scaled_number scaled_towards_one(double x) {
  scaled_number s;
  s.mantissa = std::frexp(x, &s.exponent);
  if (s.mantissa < 0x1.6a09e667f3bcdp-1) {
    s.mantissa *= 2;
    --s.exponent;
  }
  return s;
}

// Returns ln m = 2 artanh((m - 1) / (m + 1)) for a mantissa, the argument at most 0.172; the terms
// left out are below 2^-64 of it.
double_pair log_of_mantissa(double m) {
  static constexpr std::array<double, 13> series = {
      2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13, 2.0 / 15,
      2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23, 2.0 / 25, 2.0 / 27};
  const double_pair s = quotient({m - 1, 0}, exact_sum(1, m));
  const double square = s.head * s.head;
  const double rest = s.head * square * polynomial(series, square);
  return exact_sum_of_ordered(2 * s.head, 2 * s.tail + rest);
}

// Returns ln x as a pair. Requires x > 0.
double_pair natural_logarithm(double x) {
  const auto [mantissa, exponent] = scaled_towards_one(x);
  const double_pair of_mantissa = log_of_mantissa(mantissa);
  const double_pair sum = exact_sum(exponent * ln2_short.head, of_mantissa.head);
  return exact_sum_of_ordered(sum.head, sum.tail + (exponent * ln2_short.tail + of_mantissa.tail));
}

// The arguments of a logarithm that have no mantissa; empty for others.
struct special_value {
  bool is_special = false;
  double value = 0;
};

special_value special_logarithm(double x) {
  if (std::isnan(x) || x < 0) return {true, not_a_number};
  if (x == 0) return {true, -infinity};
  if (x == infinity) return {true, infinity};
  return {};
}

// Returns e^r - 1 for a pair |r| <= 0.35, the head last: the terms left out are below 2^-61 of r.
double_pair exponential_less_one(const double_pair& r) {
  static constexpr std::array<double, 13> series = {
      1.0 / 2,         1.0 / 6,          1.0 / 24,         1.0 / 120,     1.0 / 720,
      1.0 / 5040,      1.0 / 40320,      1.0 / 362880,     1.0 / 3628800, 1.0 / 39916800,
      1.0 / 479001600, 1.0 / 6227020800, 1.0 / 87178291200};
  const double rest = r.head * r.head * polynomial(series, r.head);
  return exact_sum_of_ordered(r.head, r.tail * (1 + r.head) + rest);
}

double scaled_exponential(const double_pair& r, double power) {
  const double_pair less_one = exponential_less_one(r);
  const double_pair all = exact_sum_of_ordered(1, less_one.head);
  const double mantissa = all.head + (all.tail + less_one.tail);
  const int exponent = static_cast<int>(power);
  // Multiplies by a power of two: a product that is a normal number is exact, as ldexp's is.
  if (std::abs(exponent) > 1000) return std::ldexp(mantissa, exponent);
  constexpr int bias = 1023, mantissa_bits = 52;
  const auto bits = static_cast<std::uint64_t>(exponent + bias) << mantissa_bits;
  return mantissa * std::bit_cast<double>(bits);
}

// Returns x - k ln 2 for the nearest integer k.
double_pair reduced_by_ln2(double x, double k) {
  // The first difference is exact: x and k ln2 agree to within a factor of two, or k is 0.
  const double_pair r = exact_sum(x - k * ln2_short.head, -(k * ln2_short.tail));
  return r;
}

bool is_odd(double y) { return std::abs(y) < 0x1p53 && std::fmod(y, 2) != 0 && std::trunc(y) == y; }

// The powers with an argument that has no logarithm; empty for others. Requires y != 0, x != 1.
special_value special_power(double x, double y) {
  if (std::isnan(x) || std::isnan(y)) return {true, not_a_number};
  const double base = std::abs(x);
  if (std::isinf(y)) {
    if (base == 1) return {true, 1};
    return {true, (base > 1) == (y > 0) ? infinity : 0};
  }
  if (base == 0 || base == infinity) {
    const double size = (base == 0) == (y > 0) ? 0 : infinity;
    return {true, std::signbit(x) && is_odd(y) ? -size : size};
  }
  if (x < 0 && std::trunc(y) != y) return {true, not_a_number};
  return {};
}

// Returns x^n in twice the digits, by squaring: the result is exact where it is a double. Requires
// a result between 2^-500 and 2^500, and so of all factors, and |n| <= 2^20.
double power_by_squaring(double x, int n) {
  double_pair power{1, 0}, factor{x, 0};
  for (int left = std::abs(n); left > 0; left /= 2) {
    if (left % 2 == 1) power = product(power, factor);
    if (left > 1) factor = product(factor, factor);
  }
  if (n < 0) power = quotient({1, 0}, power);
  return power.head + power.tail;
}

// Returns e^(y ln x). Requires a finite x > 0 and a finite y.
double power_of_positive(double x, double y) {
  constexpr double many = 0x1p20, far = 340;  // 2^490 and a little more
  const bool is_whole = std::trunc(y) == y && std::abs(y) <= many;
  if (is_whole) {
    const auto n = static_cast<int>(y);
    const auto [mantissa, exponent] = scaled_towards_one(x);
    if (mantissa == 1)
      return std::ldexp(1.0, static_cast<int>(std::clamp(exponent * y, -2e6, 2e6)));
    if (std::abs(y * natural_logarithm(x).head) < far) return power_by_squaring(x, n);
  }
  const double_pair log = natural_logarithm(x);
  const double rough = y * log.head;
  if (rough > 710) return infinity;
  if (rough < -746) return 0;
  // Otherwise a part of y would be lost, or the splitting of it overflow.
  constexpr double smallest = 0x1p-70;
  if (std::abs(rough) < smallest) return 1;
  const double_pair exponent = product(log, {y, 0});
  const double k = std::round(exponent.head * inverse_ln2.head);
  const double_pair r = reduced_by_ln2(exponent.head, k);
  return scaled_exponential(exact_sum_of_ordered(r.head, r.tail + exponent.tail), k);
}

// pi / 2 in parts of which an integer below 2^20 times each but the last is exact.
constexpr std::array<double, 4> half_pi_parts = {0x1.921fb54400000p+0, 0x1.0b4611a600000p-34,
                                                 0x1.3198a2e000000p-69, 0x1.b839a252049c1p-104};
constexpr double_pair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

// x = quarter pi / 2 + rest, |rest| at most about pi / 4; the quarter modulo 4.
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

// The bits of 2 / pi after the point, 64 to a word.
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
  // Bits of 2 / pi worth 2^-(place + 1) and less; those before make multiples of 4 of x 2 / pi.
  const int place = exponent - 2;
  __extension__ using wide = unsigned __int128;
  const std::array words = {bits_from(place), bits_from(place + 64), bits_from(place + 128)};
  // integer (words 2^-64 ...), modulo 1, in units of four quarters.
  const wide low = static_cast<wide>(integer) * words[2];
  const wide middle = static_cast<wide>(integer) * words[1] + static_cast<std::uint64_t>(low >> 64);
  const std::uint64_t high = integer * words[0] + static_cast<std::uint64_t>(middle >> 64);
  std::uint64_t after = static_cast<std::uint64_t>(middle), last = static_cast<std::uint64_t>(low);
  int quarter = static_cast<int>(high >> 62);
  // The fraction of a quarter, 190 bits long, as a signed one of at most a half.
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

// Returns the sine of |x| up to pi / 4; the terms left out are below 2^-59 of the sine.
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
  // A square that underflows is far below what counts beside 1.
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

// arctan(k / 8)
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

// Returns a + f b, f an eighth or so: all products exact but for the last place of the tail.
double_pair sum_with_product(double a, double f, double b) {
  const double_pair p = exact_product(f, b), sum = exact_sum(a, p.head);
  return exact_sum_of_ordered(sum.head, sum.tail + p.tail);
}

// Returns arctan(n / d) for 0 <= n <= d, d in [1, 2): arctan(k / 8) and the rest by its series, the
// rest's tangent being at most 1/16.
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
  // Far apart: the tangent itself, which may be subnormal.
  if (std::ilogb(n) - exponent < -60) return {n / d, 0};
  return arc_tangent_of_share(std::ldexp(n, 1 - exponent), 2 * unit);
}

}  // namespace

double log(double x) {
  const special_value special = special_logarithm(x);
  if (special.is_special) return special.value;
  const double_pair result = natural_logarithm(x);
  return result.head + result.tail;
}

double log10(double x) {
  const special_value special = special_logarithm(x);
  if (special.is_special) return special.value;
  const double_pair result = product(natural_logarithm(x), inverse_ln10);
  return result.head + result.tail;
}

double log2(double x) {
  const special_value special = special_logarithm(x);
  if (special.is_special) return special.value;
  const auto [mantissa, exponent] = scaled_towards_one(x);
  if (mantissa == 1) return exponent;
  const double_pair binary = product(log_of_mantissa(mantissa), inverse_ln2);
  const double_pair sum = exact_sum(exponent, binary.head);
  return sum.head + (sum.tail + binary.tail);
}

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 710) return infinity;
  if (x < -746) return 0;
  const double k = std::round(x * inverse_ln2.head);
  return scaled_exponential(reduced_by_ln2(x, k), k);
}

double exp2(double x) {
  if (std::isnan(x)) return x;
  if (x >= 1024) return infinity;
  if (x < -1076) return 0;
  const double k = std::round(x);
  if (k == x) return std::ldexp(1.0, static_cast<int>(k));
  const double share = x - k;  // exact
  if (std::abs(share) < 0x1p-60) return std::ldexp(1.0, static_cast<int>(k));
  const double_pair r = exact_product(share, ln2.head);
  return scaled_exponential(exact_sum_of_ordered(r.head, r.tail + share * ln2.tail), k);
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (y == 1) return x;
  if (y == 2) return x * x;
  const special_value special = special_power(x, y);
  if (special.is_special) return special.value;
  if (y == 0.5) return std::sqrt(x);
  const double power = power_of_positive(std::abs(x), y);
  return x < 0 && is_odd(y) ? -power : power;
}

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

// Returns (e^2x - 1) / (e^2x + 1), and for large x from above.
double tanh(double x) {
  if (std::isnan(x)) return x;
  const double size = std::abs(x);
  if (size < 0x1p-28) return x;
  if (size > 22) return std::copysign(1.0, x);
  double result = 0;
  if (size > 0.17) {
    result = 1 - 2 / (exp(2 * size) + 1);
  } else {
    const double_pair e = exponential_less_one({2 * size, 0});
    const double_pair t = quotient(e, exact_sum(2, e.head));
    result = t.head + t.tail;
  }
  return std::copysign(result, x);
}

namespace {

// Returns the root of a sum of squares in twice the digits, mended once by Newton's method.
// Requires a >= b > 0, with squares, and tails of squares, within the range of normal numbers.
double root_of_squares(double a, double b) {
  const double_pair a_square = exact_product(a, a), b_square = exact_product(b, b);
  const double_pair sum = exact_sum_of_ordered(a_square.head, b_square.head);
  const double tail = sum.tail + a_square.tail + b_square.tail;
  const double root = std::sqrt(sum.head);
  const double_pair back = exact_product(root, root);
  const double more = (((sum.head - back.head) - back.tail) + tail) / (2 * root);
  return root + more;
}

}  // namespace

double hypot(double x, double y) {
  double a = std::abs(x), b = std::abs(y);
  if (a == infinity || b == infinity) return infinity;
  if (std::isnan(a) || std::isnan(b)) return not_a_number;
  if (a < b) std::swap(a, b);
  if (b == 0) return a;
  // In the middle of the range every step commutes with scaling by a power of two, so that leaving
  // the scaling out changes no bit.
  if (a <= 0x1p400 && b >= 0x1p-400 && b >= a * 0x1p-59) return root_of_squares(a, b);
  const int exponent = std::ilogb(a);
  if (exponent - std::ilogb(b) > 60) return a + b;
  return std::ldexp(root_of_squares(std::ldexp(a, -exponent), std::ldexp(b, -exponent)), exponent);
}

}  // namespace asterism::internal::elementary
