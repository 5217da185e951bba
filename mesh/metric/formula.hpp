// SPDX-License-Identifier: MIT
//
// Reads a formula in x and y from text into steps, which plane_expression evaluates in doubles and
// expression_enclosure in intervals.
//
// The language is that of the library muparser, whose users know it: numbers with a decimal point
// in any locale, pi, e, x, y, + - * / ^, comparisons, && and ||, `a ? b : c`, and the functions of
// formula_reader.cpp; names are case sensitive. A sign binds less than ^, and ^ groups from the
// right. Assignments and lists of values are refused. Source: muparser's manual, "Features".
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"

namespace asterism::internal {

struct formula {
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
    arc_sine,
    arc_cosine,
    arc_tangent,
    angle,  // atan2
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    area_sine,     // asinh
    area_cosine,   // acosh
    area_tangent,  // atanh
    exponential,
    logarithm,
    scaled_logarithm,
    root,
    absolute,
    sign,
    whole,  // rint
    total,  // of sum and avg: an addition
    lesser,
    greater
  };
  // A step of the evaluation. It takes the results of its operands' steps, by their numbers; each
  // comes after its operands.
  struct step {
    operation what;
    double constant = 0;  // of a scaled logarithm its base
    std::size_t first = 0, second = 0, third = 0;

    friend auto operator<=>(const step& a, const step& b) = default;
  };

  // Fails with what is wrong and its position (from 1) in `text`.
  static result<formula> read(const std::string& text);

  std::vector<step> steps;  // the last makes the value
};

}  // namespace asterism::internal
