// SPDX-License-Identifier: MIT
//
// Defines an interval that carries what it encloses and aborts when it does not: the number type of
// the self-check build (option ASTERISM_SELF_CHECK), where it takes the place of `interval`.
// Hundreds of times slower; not for use elsewhere.
//
// The shadow of an interval [lo, hi] is the exact least and greatest value that the operations so
// far can give on the boxes that intervals were made from. Sums and products of dyadic numbers are
// dyadic, so the shadow is a pair of them, each computed from the shadows of the operands; a square
// root is enclosed between two dyadic numbers, and from then on an end of the shadow is a range. By
// induction over the operations: if every operation encloses what it should, the least value is
// never below lo and the greatest never above hi. A violation therefore proves an operation wrong.
// Ends that are ranges weaken the check by the width of the range, 2^-400 of the value at a square
// root.
//
// An interval with an end that is infinite or not a number promises nothing: its shadow is unknown,
// and so is that of everything computed from it.
#pragma once

#include <optional>

#include "asterism/core/dyadic.hpp"
#include "asterism/core/rounded_interval.hpp"

namespace asterism::internal {

// A real number known to lie in [low, high]; known exactly when they are equal.
struct dyadic_range {
  dyadic low, high;
  bool exact = true;  // low == high
};

class shadowed_interval {
 public:
  using enclosure = rounded_interval;

  shadowed_interval() : shadowed_interval(0.0) {}
  shadowed_interval(int value) : shadowed_interval(static_cast<double>(value)) {}
  shadowed_interval(double value) : shadowed_interval(value, value) {}
  shadowed_interval(double low, double high);

  double inf() const { return box_.inf(); }
  double sup() const { return box_.sup(); }

  friend shadowed_interval operator+(const shadowed_interval& a, const shadowed_interval& b);
  friend shadowed_interval operator-(const shadowed_interval& a, const shadowed_interval& b);
  friend shadowed_interval operator*(const shadowed_interval& a, const shadowed_interval& b);
  shadowed_interval operator-() const;

  // Returns the squares: none is negative, also where the interval straddles zero.
  friend shadowed_interval squared(const shadowed_interval& a);
  // Returns the square roots of the part of the interval that is not negative.
  friend shadowed_interval root_of_non_negative(const shadowed_interval& a);

 private:
  struct ends {
    dyadic_range least, greatest;
    bool point = false;  // least and greatest are one number, known exactly
  };

  shadowed_interval(const char* operation, const enclosure& box, std::optional<ends> shadow);
  void check(const char* operation) const;

  enclosure box_;
  std::optional<ends> shadow_;
};

}  // namespace asterism::internal
