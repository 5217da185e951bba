// SPDX-License-Identifier: MIT
//
// Reads a formula in x and y, and encloses its values and derivatives over boxes. The formula has
// the meaning that plane_expression gives it; a separate reader is needed, as muparser evaluates in
// doubles alone and does not export how it read a formula.
//
// Its language is a part of muparser's: numbers, pi, e, x, y, + - * / ^, comparisons, && and ||,
// `a ? b : c`, and sin, cos, tan, atan, sinh, cosh, tanh, exp, ln, log, log2, log10, sqrt, abs,
// min, max, sum and avg. Precedence is muparser's: a sign binds less than ^, and ^ groups from the
// right. Where a comparison is not decided over a box, or an operand may have no value there (a
// NaN, which comparisons, min and max hide), both cases are enclosed, with infinite derivatives.
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

class expression_enclosure {
 public:
  // Reads the formula; returns nothing if the formula has parts outside this language, or is
  // invalid.
  static std::optional<expression_enclosure> parse(const std::string& text);

  // Returns the enclosure. Requires a floating_point_scope(rounding::upward); several threads may
  // call it.
  interval_jet over(const plane_jet& at) const;

 private:
  friend class formula_reader;
  enum class operation {
    constant,
    x,
    y,
    add,
    subtract,
    multiply,
    divide,
    power,
    negate,
    less,
    less_or_equal,
    equal,
    conjunction,
    disjunction,
    choice,
    sine,
    cosine,
    tangent,
    arc_tangent,
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    exponential,
    logarithm,
    scaled_logarithm,
    root,
    absolute,
    lesser,
    greater
  };
  // A step of the evaluation. It takes the results of its operands' steps, by their numbers; each
  // comes after its operands.
  struct step {
    operation what;
    double constant = 0;
    std::size_t first = 0, second = 0, third = 0;

    friend auto operator<=>(const step& a, const step& b) = default;
  };
  // Enclosure of a step's result, for the points where it is a number.
  struct evaluation {
    interval_jet jet;
    bool may_be_nan = false;  // somewhere in the box
  };

  // True for operations whose result may be a number though an operand is NaN.
  static bool hides_nan(operation what);
  // True for conditions, whose results are 0 or 1.
  static bool is_condition(operation what);
  // Returns an enclosure of all possible outcomes of an operation that hides a NaN.
  static interval_jet any_outcome(const step& s, const std::vector<evaluation>& made);
  // True if the operation may have no value (NaN) somewhere in the box.
  static bool makes_nan(operation what, const interval_jet& operand, const interval_jet& value);
  static interval_jet value_of(const step& s, const std::vector<evaluation>& made,
                               const plane_jet& at);
  static interval_jet condition_of(operation what, const interval_jet& a, const interval_jet& b);
  static interval_jet chosen(const interval_jet& condition, const interval_jet& yes,
                             const interval_jet& no);
  static interval_jet function_of(operation what, const interval_jet& a);
  static interval_jet power_of(const interval_jet& base, const interval_jet& exponent);

  std::vector<step> steps_;  // the last makes the value
};

}  // namespace asterism::internal
