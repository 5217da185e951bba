// SPDX-License-Identifier: MIT
//
// Reads a formula in x and y from text and evaluates it in doubles.
//
// The language is muparser's: + - * / ^, comparisons and `a ? b : c`, sin, cos, exp, sqrt, abs,
// min, max and so on, case sensitive, decimal points in any locale; `pi` and `e` are constants.
// Assignments and lists of values are refused. Source: muparser's manual, "Features".
#pragma once

#include <memory>
#include <string>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

class plane_expression {
 public:
  // Reads the formula. Fails with the parser's words and the position (from 1) in `text`.
  static result<plane_expression> parse(const std::string& text);

  plane_expression(plane_expression&&) noexcept;
  plane_expression& operator=(plane_expression&&) noexcept;
  ~plane_expression();

  // Evaluates the formula. The value may be infinite or not a number. Not safe to call from two
  // threads at once.
  result<double> operator()(const point& q) const;

 private:
  struct state;
  explicit plane_expression(std::unique_ptr<state> s);
  std::unique_ptr<state> state_;
};

}  // namespace asterism::internal
