// SPDX-License-Identifier: MIT
//
// Defines exact dyadic numbers m * 2^e with an integer m of any size: closed under +, -, * and
// halving, and every finite double is one. No rationals and no gcd are ever needed.
//
// Ranges: the exponent is a long; sums align mantissas, so adding 2^1000 and 2^-1000 costs 2000
// bits, not an error. Mantissas of up to integer::inline_limbs limbs ask for no memory.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>

#include "asterism/core/integer.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

using asterism::sign_of;  // of a double, beside those below

class dyadic {
 public:
  dyadic() = default;
  dyadic(int value) : mantissa_(value) {}
  // Converts exactly, whatever the floating-point environment. Requires a finite value.
  dyadic(double value);
  dyadic(integer mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  friend dyadic operator+(const dyadic& a, const dyadic& b) { return sum(a, b, false); }
  friend dyadic operator-(const dyadic& a, const dyadic& b) { return sum(a, b, true); }
  friend dyadic operator*(const dyadic& a, const dyadic& b) {
    dyadic product;
    product.mantissa_.set_product(a.mantissa_, b.mantissa_);
    product.exponent_ = a.exponent_ + b.exponent_;
    return product;
  }
  dyadic operator-() const {
    dyadic negated = *this;
    negated.mantissa_.negate();
    return negated;
  }

  // Returns *this * 2^shift.
  dyadic scaled(long shift) const { return {mantissa_, exponent_ + shift}; }
  bool is_zero() const { return mantissa_.is_zero(); }
  sign sign_value() const { return mantissa_.sign_value(); }
  // Returns e with 2^(e-1) <= |value| < 2^e. Requires a value that is not zero.
  long magnitude() const { return mantissa_.bit_length() + exponent_; }
  // Drops trailing zero bits of the mantissa: the same value in the shortest form.
  void shorten();
  const integer& mantissa() const { return mantissa_; }
  long exponent() const { return exponent_; }

 private:
  static dyadic sum(const dyadic& a, const dyadic& b, bool subtract);

  integer mantissa_;
  long exponent_ = 0;  // of zero: anything
};

inline dyadic::dyadic(double value) {
  constexpr int fraction_bits = 52;
  constexpr int exponent_bias = 1075;  // of the fraction read as an integer
  const auto bits = std::bit_cast<std::uint64_t>(value);
  std::uint64_t fraction = bits & ((std::uint64_t{1} << fraction_bits) - 1);
  const int biased = static_cast<int>((bits >> fraction_bits) & 0x7FF);
  assert(biased != 0x7FF);
  if (biased != 0) fraction |= std::uint64_t{1} << fraction_bits;
  if (fraction == 0) return;
  const int zeros = std::countr_zero(fraction);
  mantissa_ = integer(fraction >> zeros, (bits >> 63) != 0);
  exponent_ = (biased == 0 ? 1 : biased) - exponent_bias + zeros;
}

inline dyadic dyadic::sum(const dyadic& a, const dyadic& b, bool subtract) {
  // Ignores the exponent of a zero, which means nothing.
  if (b.is_zero()) return a;
  if (a.is_zero()) return subtract ? -b : b;
  dyadic result;
  if (a.exponent_ >= b.exponent_) {
    result.mantissa_.set_sum(a.mantissa_, static_cast<unsigned long>(a.exponent_ - b.exponent_),
                             b.mantissa_, subtract);
    result.exponent_ = b.exponent_;
  } else {
    result.mantissa_.set_sum(b.mantissa_, static_cast<unsigned long>(b.exponent_ - a.exponent_),
                             a.mantissa_, subtract);
    result.exponent_ = a.exponent_;
    if (subtract) result.mantissa_.negate();
  }
  return result;
}

inline void dyadic::shorten() {
  if (is_zero()) {
    exponent_ = 0;
    return;
  }
  const unsigned long zeros = mantissa_.trailing_zeros();
  if (zeros == 0) return;
  mantissa_.shift_down(zeros);
  exponent_ += static_cast<long>(zeros);
}

inline uncertain_sign sign_of(const dyadic& x) { return x.sign_value(); }
inline bool operator<(const dyadic& a, const dyadic& b) {
  return (a - b).sign_value() == sign::negative;
}
inline bool operator==(const dyadic& a, const dyadic& b) { return (a - b).is_zero(); }

}  // namespace asterism::internal
