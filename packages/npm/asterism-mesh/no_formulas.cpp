// SPDX-License-Identifier: MIT
//
// Replaces mesh/metric/plane_expression.cpp by a reader that refuses every formula: programs of
// JavaScript give metrics as functions.
#include <limits>

#include "asterism/mesh/metric/plane_expression.hpp"

namespace asterism::internal {

result<plane_expression> plane_expression::parse(const std::string& text) {
  return error{"'" + text + "': formulas are not part of this module; give a function of x and y"};
}

// Returns no number: there is no formula to evaluate.
double plane_expression::operator()(const point&) const {
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace asterism::internal
