// SPDX-License-Identifier: MIT
//
// Each function reduces its argument, sums a Taylor polynomial of the reduced argument, and adds
// the largest term last together with its rounding error. The error of the result is therefore
// little more than that of the last rounding. A constant with more digits than a double holds is a
// sum of doubles; the tests compute these constants anew.
#include "asterism/core/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "asterism/core/double_pair.hpp"

namespace asterism::internal::elementary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// ln 2 as a pair; ln 2 with a head of 38 bits, whose product with an integer below 2^15 is exact; 1
// / ln 2; 1 / ln 10.
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
  // Splits a normal number by its bits, as std::frexp would.
  constexpr std::uint64_t exponent_bits = 0x7ff, mantissa_bits = 52, one_half = 1022;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = bits >> mantissa_bits & exponent_bits;
  if (biased != 0 && biased != exponent_bits) {
    s.exponent = static_cast<int>(biased) - static_cast<int>(one_half);
    s.mantissa = std::bit_cast<double>((bits & ~(exponent_bits << mantissa_bits)) |
                                       one_half << mantissa_bits);
  } else {
    s.mantissa = std::frexp(x, &s.exponent);
  }
  if (s.mantissa < 0x1.6a09e667f3bcdp-1) {
    s.mantissa *= 2;
    --s.exponent;
  }
  return s;
}

// Returns ln m = 2 artanh((m - 1) / (m + 1)) for a mantissa, the argument at most 0.172; the
// omitted terms of the series are below 2^-64 of the result.
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

// Returns the logarithm of NaN, infinity, zero and negative numbers; empty for other arguments.
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

// Returns e^r - 1 for a pair |r| <= 0.35, adding the head last: the omitted terms of the series are
// below 2^-61 of r.
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
  // Multiplies by the power of two: the product is exact where it is a normal number, like that of
  // ldexp.
  if (std::abs(exponent) > 1000) return std::ldexp(mantissa, exponent);
  constexpr int bias = 1023, mantissa_bits = 52;
  const auto bits = static_cast<std::uint64_t>(exponent + bias) << mantissa_bits;
  return mantissa * std::bit_cast<double>(bits);
}

// Returns x - k ln 2, where k is the integer nearest to x / ln 2.
double_pair reduced_by_ln2(double x, double k) {
  // Subtracts exactly: x and k ln2 agree to within a factor of two, or k is 0.
  const double_pair r = exact_sum(x - k * ln2_short.head, -(k * ln2_short.tail));
  return r;
}

bool is_odd(double y) { return std::abs(y) < 0x1p53 && std::fmod(y, 2) != 0 && std::trunc(y) == y; }

// Returns x^y where e^(y ln x) cannot give it: for NaN, infinities, x = 0, and x < 0 without an
// integer y. Returns empty for other arguments. Requires y != 0, x != 1.
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
  // Returns 1 if |y ln x| is tiny, where splitting y for the exact product could lose bits or
  // overflow.
  constexpr double smallest = 0x1p-70;
  if (std::abs(rough) < smallest) return 1;
  const double_pair exponent = product(log, {y, 0});
  const double k = std::round(exponent.head * inverse_ln2.head);
  const double_pair r = reduced_by_ln2(exponent.head, k);
  return scaled_exponential(exact_sum_of_ordered(r.head, r.tail + exponent.tail), k);
}

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

// Returns (e^2x - 1) / (e^2x + 1); beyond |x| = 0.17 as 1 - 2 / (e^2x + 1), beyond 22 as 1 with the
// sign of x.
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

double hypot(double x, double y) {
  double a = std::abs(x), b = std::abs(y);
  if (a == infinity || b == infinity) return infinity;
  if (std::isnan(a) || std::isnan(b)) return not_a_number;
  if (a < b) std::swap(a, b);
  if (b == 0) return a;
  // Skips scaling in the middle of the range, where every step commutes with scaling by a power of
  // two, so that no bit changes.
  if (a <= 0x1p400 && b >= 0x1p-400 && b >= a * 0x1p-59) return root_of_squares(a, b);
  const int exponent = std::ilogb(a);
  if (exponent - std::ilogb(b) > 60) return a + b;
  return std::ldexp(root_of_squares(std::ldexp(a, -exponent), std::ldexp(b, -exponent)), exponent);
}

}  // namespace asterism::internal::elementary
