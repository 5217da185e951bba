// SPDX-License-Identifier: MIT
//
// Exact dyadic numbers m * 2^e with an integer m of any size: closed under +, -, * and halving,
// and every finite double is one. No rationals and no gcd are ever needed.
//
// Ranges: the exponent is a long; sums align mantissas, so adding 2^1000 and 2^-1000 costs 2000
// bits, not an error.
#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "asterism/core/sign.hpp"

namespace asterism {

class dyadic {
 public:
  using integer =
      boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

  dyadic() = default;
  dyadic(int value) : mantissa_(value) {}
  // Exact, whatever the floating-point environment. Requires a finite value.
  dyadic(double value);
  dyadic(integer mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  friend dyadic operator+(const dyadic& a, const dyadic& b) { return sum(a, b, false); }
  friend dyadic operator-(const dyadic& a, const dyadic& b) { return sum(a, b, true); }
  friend dyadic operator*(const dyadic& a, const dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  dyadic operator-() const { return {-mantissa_, exponent_}; }

  // this * 2^shift
  dyadic scaled(long shift) const { return {mantissa_, exponent_ + shift}; }
  bool is_zero() const { return mantissa_.is_zero(); }
  sign sign_value() const { return to_sign(mantissa_.sign()); }
  // e with 2^(e-1) <= |value| < 2^e. Requires a value that is not zero.
  long magnitude() const;
  // Drops trailing zero bits of the mantissa: the same value in the shortest form.
  void shorten();
  const integer& mantissa() const { return mantissa_; }
  long exponent() const { return exponent_; }

 private:
  static dyadic sum(const dyadic& a, const dyadic& b, bool subtract);

  integer mantissa_ = 0;
  long exponent_ = 0;
};

inline uncertain_sign sign_of(const dyadic& x) { return x.sign_value(); }
inline bool operator<(const dyadic& a, const dyadic& b) {
  return (a - b).sign_value() == sign::negative;
}
inline bool operator==(const dyadic& a, const dyadic& b) { return (a - b).is_zero(); }

}  // namespace asterism
