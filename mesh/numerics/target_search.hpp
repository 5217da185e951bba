// SPDX-License-Identifier: MIT
//
// Searches for the number with which a quantity meets its target, by measuring the quantity.
//
//   target_search search;
//   while (std::abs(off = std::log(measure(std::exp(search.at())) / target)) > close)
//     search.take(off);
#pragma once

#include <limits>
#include <optional>

namespace asterism::internal {

// Searches for the zero of a function that grows with its argument. Callers limit the number of
// steps: the function may jump from below zero to above, or have no zero.
//
// Arguments and values are logarithms: of a factor, and of a quantity over its target. A quantity
// in proportion to the factor then has the slope 1, which the first step assumes.
class target_search {
 public:
  // `start` is the first argument to try. `slowest` is the least slope assumed, from 0 to 1: above
  // 0 where a measurement costs more with the factor, and a slope may be missed by chance.
  explicit target_search(double slowest = 0, double start = 0) : slowest_(slowest), at_(start) {}

  // Returns the argument to try next.
  double at() const { return at_; }
  // Returns the least absolute value entered so far; infinity before the first.
  double least_off() const { return least_; }
  // Returns the distance between the last arguments that were too small and too large; infinity
  // until both are known.
  double width() const;
  // True if no value of one sign was found, and the last seven of the other were alike, to 1e-9.
  bool is_saturated() const;

  // Enters the value at the argument at(), and its slope where it is known. Returns whether no
  // value before was as near to zero. Enters no NaN; then at() stays the same.
  //
  // With values of one sign alone, the next argument is that of the line through the last two, or
  // with the slope given, and no farther away than the value says with the slope 1, by a factor of
  // 16. With values of both signs it is on the line through the last two of different signs, a
  // tenth of the way from either end or more. After two values of one sign, that of the other
  // counts half, so that both ends come nearer (the Illinois method: Dowell and Jarratt, BIT 11,
  // 1971).
  bool take(double off, std::optional<double> slope = std::nullopt);

 private:
  struct place {
    double at, off;
  };

  double slope_after(const place& now) const;
  void step_outward(double off, double slope);
  void step_between();

  double slowest_, at_;
  double least_ = std::numeric_limits<double>::infinity();
  std::optional<place> below_, above_, last_;
  int alike_ = 0;  // number of values in a row that equal the one before, to 1e-9
};

}  // namespace asterism::internal
