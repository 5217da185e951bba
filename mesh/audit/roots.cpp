// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/roots.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/audit/rounded_rational.hpp"

namespace asterism::internal::audit_detail {
namespace {

rational root_towards(const rational& square, direction to) {
  constexpr unsigned bits_of_roots = 200;
  return as_rational(rounded_root(rounded(square, bits_of_roots, to), bits_of_roots, to));
}

constexpr unsigned double_bits = 53;

}  // namespace

rational root_above(const rational& square) { return root_towards(square, direction::up); }
rational root_below(const rational& square) { return root_towards(square, direction::down); }

double double_above(const rational& number) {
  return number < 0 ? -as_double(rounded(-number, double_bits, direction::down), direction::down)
                    : as_double(rounded(number, double_bits, direction::up), direction::up);
}

double root_rounded_up(const rational& square) {
  const binary_number rounded_square = rounded(square, double_bits, direction::up);
  return as_double(rounded_root(rounded_square, double_bits, direction::up), direction::up);
}

double unit_in_last_place(double size) {
  constexpr int least = -1074;
  return size > 0 ? std::ldexp(1.0, std::max(std::ilogb(size) - 52, least)) : 0x1p-1074;
}

}  // namespace asterism::internal::audit_detail
