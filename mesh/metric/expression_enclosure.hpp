// SPDX-License-Identifier: MIT
//
// Reads a formula in x and y as plane_expression does, and encloses it and its derivatives over
// boxes.
//
// Its language is a part of muparser's: numbers, pi, e, x, y, + - * / ^, comparisons, && and ||,
// `a ? b : c`, and sin, cos, tan, atan, sinh, cosh, tanh, exp, ln, log, log2, log10, sqrt, abs,
// min, max, sum and avg. Precedence is muparser's: a sign binds less than ^, and ^ groups from the
// right. Where a comparison is not decided over a box, both cases are enclosed, with infinite
// derivatives.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

class expression_enclosure {
 public:
  // Reads the formula; nothing where it has something else, or is no formula.
  static std::optional<expression_enclosure> parse(const std::string& text);

  // Returns the enclosure. In a floating_point_scope(rounding::upward); several threads may ask.
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
  // A step takes what its operands' steps made, by their numbers; each comes after its operands.
  struct step {
    operation what;
    double constant = 0;
    std::size_t first = 0, second = 0, third = 0;
  };

  static interval_jet value_of(const step& s, const std::vector<interval_jet>& made,
                               const plane_jet& at);
  static interval_jet function_of(operation what, const interval_jet& a);
  static interval_jet power_of(const interval_jet& base, const interval_jet& exponent);

  std::vector<step> steps_;  // the last makes the value
};

}  // namespace asterism::internal
