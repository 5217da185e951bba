// SPDX-License-Identifier: MIT
//
// Replaces mesh/metric/plane_expression.cpp: refuses formulas, since their parser is a library of
// its own. A program of JavaScript gives a function instead.
#include "asterism/mesh/metric/plane_expression.hpp"

namespace asterism::internal {

struct plane_expression::state {};

plane_expression::plane_expression(std::unique_ptr<state> s) : state_(std::move(s)) {}
plane_expression::plane_expression(plane_expression&&) noexcept = default;
plane_expression& plane_expression::operator=(plane_expression&&) noexcept = default;
plane_expression::~plane_expression() = default;

result<plane_expression> plane_expression::parse(const std::string& text) {
  return error{"'" + text + "': formulas are not part of this module; give a function of x and y"};
}

result<double> plane_expression::operator()(const point&) const {
  return error{"formulas are not part of this module"};
}

}  // namespace asterism::internal
