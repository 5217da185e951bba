// SPDX-License-Identifier: MIT
//
// The two arithmetics in which the conditions of a proof are decided: doubles with a bound of their
// error, and rationals where that bound leaves the sign open.
#pragma once

#include <boost/multiprecision/gmp.hpp>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"
#include "asterism/kernels/bounded.hpp"

namespace asterism::internal::proof_detail {

using rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

inline uncertain_bool exceeds_zero(const bounded& a) {
  if (a.certainly_positive()) return true;
  if (a.certainly_negative()) return false;
  return {};
}
inline uncertain_bool exceeds_zero(const rational& a) { return a > 0; }
// Differs from `exceeds_zero` only for a value that is exactly zero.
inline uncertain_bool reaches_zero(const bounded& a) { return exceeds_zero(a); }
inline uncertain_bool reaches_zero(const rational& a) { return a >= 0; }

// Returns the answer of `condition`, which is called with a zero of the arithmetic to use: doubles
// first, rationals if these leave it open.
template <class Condition>
bool decide(const Condition& condition) {
  const uncertain_bool quick = condition(bounded(0));
  if (quick.certain()) return quick.value();
  return condition(rational(0)).value();
}

template <class Number>
struct vector2 {
  Number x, y;

  friend vector2 operator+(const vector2& a, const vector2& b) { return {a.x + b.x, a.y + b.y}; }
  friend vector2 operator-(const vector2& a, const vector2& b) { return {a.x - b.x, a.y - b.y}; }
  friend vector2 operator*(const Number& k, const vector2& a) { return {k * a.x, k * a.y}; }
};

template <class Number>
Number dot(const vector2<Number>& a, const vector2<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class Number>
Number cross(const vector2<Number>& a, const vector2<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class Number>
struct tensor {
  Number m11, m12, m22;

  explicit tensor(const metric_tensor& m) : m11(m.m11), m12(m.m12), m22(m.m22) {}
  Number determinant() const { return m11 * m22 - m12 * m12; }
  vector2<Number> operator*(const vector2<Number>& a) const {
    return {m11 * a.x + m12 * a.y, m12 * a.x + m22 * a.y};
  }
  Number square(const vector2<Number>& a) const { return dot(a, *this * a); }
};

template <class Number>
vector2<Number> way(const point& from, const point& to) {
  return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y)};
}

}  // namespace asterism::internal::proof_detail
