// SPDX-License-Identifier: MIT
//
// Defines signs, and the three-valued answers of arithmetics that may not know.
//
// A sign is never guessed: an arithmetic that cannot decide returns an empty `uncertain`, which
// has no conversion to a sign. "Undecided" is therefore a type, not a value of `sign`.
#pragma once

#include <cassert>

namespace asterism {

// The sign of a real number.
enum class sign : int { negative = -1, zero = 0, positive = 1 };

// Returns the sign of -x for x of sign s.
constexpr sign operator-(sign s) { return static_cast<sign>(-static_cast<int>(s)); }
// Returns the sign of a product.
constexpr sign operator*(sign a, sign b) {
  return static_cast<sign>(static_cast<int>(a) * static_cast<int>(b));
}
// Returns -1, 0 or 1.
constexpr int to_int(sign s) { return static_cast<int>(s); }
// Returns the sign of an integer.
constexpr sign to_sign(int value) {
  return value > 0 ? sign::positive : value < 0 ? sign::negative : sign::zero;
}

// An answer, or no answer: the arithmetic could not decide.
template <class T>
class uncertain {
 public:
  constexpr uncertain() = default;  // undecided
  constexpr uncertain(T value) : value_(value), certain_(true) {}

  constexpr bool certain() const { return certain_; }
  // Requires certain().
  constexpr T value() const {
    assert(certain_);
    return value_;
  }
  constexpr bool certainly(T expected) const { return certain_ && value_ == expected; }

 private:
  T value_{};
  bool certain_ = false;
};

// Sign of a real number, or undecided.
using uncertain_sign = uncertain<sign>;
// Yes or no, or undecided.
using uncertain_bool = uncertain<bool>;
// Number of points, or undecided.
using uncertain_int = uncertain<int>;

// Returns Kleene's three-valued "not".
constexpr uncertain_bool operator!(uncertain_bool a) {
  return a.certain() ? uncertain_bool(!a.value()) : a;
}
// Returns Kleene's three-valued "and": a certain `false` decides alone.
constexpr uncertain_bool operator&(uncertain_bool a, uncertain_bool b) {
  if (a.certainly(false) || b.certainly(false)) return false;
  if (a.certain() && b.certain()) return true;
  return {};
}
// Returns Kleene's three-valued "or": a certain `true` decides alone.
constexpr uncertain_bool operator|(uncertain_bool a, uncertain_bool b) { return !((!a) & (!b)); }

// True if the sign is certainly positive; undecided if the sign is.
constexpr uncertain_bool is_positive(uncertain_sign s) {
  return s.certain() ? uncertain_bool(s.value() == sign::positive) : uncertain_bool();
}
// True if the sign is certainly negative; undecided if the sign is.
constexpr uncertain_bool is_negative(uncertain_sign s) {
  return s.certain() ? uncertain_bool(s.value() == sign::negative) : uncertain_bool();
}
// True if the sign is certainly zero; undecided if the sign is.
constexpr uncertain_bool is_zero(uncertain_sign s) {
  return s.certain() ? uncertain_bool(s.value() == sign::zero) : uncertain_bool();
}
// Returns the opposite sign; undecided if the sign is.
constexpr uncertain_sign operator-(uncertain_sign s) {
  return s.certain() ? uncertain_sign(-s.value()) : s;
}

// Returns the sign of the double itself, which is no more than a guess at the sign of a real number
// that the double rounds. For this reason nothing but the plain double kernel evaluates a predicate
// with doubles.
constexpr uncertain_sign sign_of(double x) { return to_sign((x > 0) - (x < 0)); }

}  // namespace asterism
