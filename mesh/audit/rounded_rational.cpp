// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/rounded_rational.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asterism::internal::audit_detail {
namespace {

// Returns the number of bits of a whole number above 0.
long length_of(const whole_number& n) { return static_cast<long>(msb(n)) + 1; }

whole_number shifted_up(const whole_number& n, long bits) {
  return n << static_cast<unsigned>(bits);
}

// Returns numerator / denominator, rounded to a whole number.
whole_number quotient(const whole_number& numerator, const whole_number& denominator,
                      direction to) {
  whole_number whole, rest;
  divide_qr(numerator, denominator, whole, rest);
  return to == direction::up && rest != 0 ? whole_number(whole + 1) : whole;
}

// Returns mantissa * 2^exponent in units of 2^unit, rounded to a whole number.
whole_number in_units(const binary_number& number, long unit, direction to) {
  const long up = number.exponent - unit;
  if (up >= 0) return shifted_up(number.mantissa, up);
  return quotient(number.mantissa, shifted_up(whole_number(1), -up), to);
}

}  // namespace

binary_number rounded(const rational& number, unsigned bits, direction to) {
  return rounded_quotient(numerator(number), denominator(number), bits, to);
}

binary_number rounded_quotient(const whole_number& top, const whole_number& bottom, unsigned bits,
                               direction to) {
  if (top == 0) return {};
  // 2^(length - 1) < number < 2^(length + 1): one bit may be too many, and is rounded away.
  const long unit = length_of(top) - length_of(bottom) - static_cast<long>(bits);
  const auto divided = [&](long in_unit) {
    return in_unit >= 0 ? quotient(top, shifted_up(bottom, in_unit), to)
                        : quotient(shifted_up(top, -in_unit), bottom, to);
  };
  whole_number mantissa = divided(unit);
  if (length_of(mantissa) > static_cast<long>(bits)) return {divided(unit + 1), unit + 1};
  return {std::move(mantissa), unit};
}

binary_number rounded_root(const binary_number& square, unsigned bits, direction to) {
  if (square.mantissa == 0) return {};
  // A radicand of 2 * bits or 2 * bits - 1 bits at least, with an even exponent, has a root of
  // `bits` bits.
  long up = std::max(2 * static_cast<long>(bits) - length_of(square.mantissa), 0L);
  if ((square.exponent - up) % 2 != 0) ++up;
  const whole_number radicand = shifted_up(square.mantissa, up);
  whole_number rest, root = sqrt(radicand, rest);
  if (to == direction::up && rest != 0) root += 1;
  const long unit = (square.exponent - up) / 2, surplus = length_of(root) - static_cast<long>(bits);
  if (surplus <= 0) return {std::move(root), unit};
  // Rounds twice in one direction, which equals rounding once.
  return {in_units({std::move(root), unit}, unit + surplus, to), unit + surplus};
}

rational as_rational(const binary_number& number) {
  const whole_number one(1);
  return number.exponent >= 0 ? rational(shifted_up(number.mantissa, number.exponent))
                              : rational(number.mantissa, shifted_up(one, -number.exponent));
}

double as_double(const binary_number& number, direction to) {
  if (number.mantissa == 0) return 0;
  constexpr long double_bits = 53, least = -1074, largest = 1024;
  const long top = length_of(number.mantissa) + number.exponent;
  if (top > largest)
    return to == direction::up ? std::numeric_limits<double>::infinity()
                               : std::numeric_limits<double>::max();
  const long unit = std::max(top - double_bits, least);
  const whole_number mantissa =
      top < least ? whole_number(to == direction::up ? 1 : 0) : in_units(number, unit, to);
  return std::ldexp(mantissa.convert_to<double>(), static_cast<int>(unit));
}

namespace {

// Returns arctan(1 / n) * 2^bits, too small by less than one unit for each term.
whole_number reciprocal_arctangent(unsigned n, unsigned bits) {
  whole_number power = shifted_up(whole_number(1), bits) / n, sum = 0;
  for (unsigned k = 1; power != 0; k += 2) {
    if (k % 4 == 1)
      sum += power / k;
    else
      sum -= power / k;
    power /= n * n;
  }
  return sum;
}

// Returns pi * 2^bits, off by less than 10 * bits units. By Machin's formula, pi = 16
// arctan(1/5) - 4 arctan(1/239), with at most bits / 4 terms, each off by less than 2 units; its
// first 640 bits behind the point are kept here, since an audit needs no more.
whole_number pi_in_units(unsigned bits) {
  constexpr unsigned kept = 640;
  if (bits > kept)
    return 16 * reciprocal_arctangent(5, bits) - 4 * reciprocal_arctangent(239, bits);
  const whole_number pi(
      "0x3243f6a8885a308d313198a2e03707344a4093822299f31d0082efa98ec4e6c8"
      "9452821e638d01377be5466cf34e90c6cc0ac29b7c97c50dd3f84d5b5b547091"
      "79216d5d98979fb1bd1310ba698dfb5ac");
  return pi >> (kept - bits);
}

}  // namespace

// Works with `bits` bits behind the point, in units of the last of them. The angle is at most pi /
// 2, so its error is below 10 * bits units as well. Sine and cosine have at most `bits` terms, each
// off by less than 3 units, and their derivative by the angle is at most 1: their errors are less
// than 2^6 * bits units.
cotangent_bounds squared_cotangent_of(double degrees) {
  constexpr unsigned precision = 256;
  const int size = std::ilogb(degrees);
  const unsigned bits = 2 * precision + static_cast<unsigned>(std::max(-2 * size, 0));
  const whole_number pi = pi_in_units(bits);
  constexpr int fraction_bits = 52;
  const whole_number mantissa(static_cast<long long>(std::ldexp(degrees, fraction_bits - size)));
  const long up = static_cast<long>(size) - fraction_bits;
  whole_number angle = pi * mantissa;
  angle = up >= 0 ? shifted_up(angle, up) : whole_number(angle >> static_cast<unsigned>(-up));
  angle /= 180;

  const whole_number one = shifted_up(whole_number(1), bits);
  whole_number sine = 0, cosine = 0, term = one;
  for (unsigned k = 0; term != 0; ++k) {
    whole_number& part = k % 2 == 0 ? cosine : sine;
    if (k % 4 < 2)
      part += term;
    else
      part -= term;
    term = ((term * angle) >> bits) / (k + 1);
  }
  const whole_number error = 64 * whole_number(bits);
  const auto squared_ratio = [&](const whole_number& a, const whole_number& b, direction to) {
    return as_rational(rounded_quotient(a * a, b * b, precision, to));
  };
  return {squared_ratio(cosine - error, sine + error, direction::down),
          squared_ratio(cosine + error, sine - error, direction::up)};
}

}  // namespace asterism::internal::audit_detail
