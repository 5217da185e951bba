// SPDX-License-Identifier: MIT
//
// Encloses the values and derivatives of a formula in x and y over boxes.
//
// The formula is without asin, acos, atan2, asinh, acosh, atanh, sign and rint. Where a comparison
// is not decided over a box, or an operand may have no value there (a NaN, which comparisons, min
// and max hide), both cases are enclosed, with infinite derivatives.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "asterism/mesh/metric/formula.hpp"
#include "asterism/mesh/metric/interval_jet.hpp"

namespace asterism::internal {

class expression_enclosure {
 public:
  // Reads the formula; returns nothing if it is invalid, or has parts that are not enclosed.
  static std::optional<expression_enclosure> parse(const std::string& text);

  // Returns the enclosure. Requires a floating_point_scope(rounding::upward); several threads may
  // call it.
  interval_jet over(const plane_jet& at) const;

 private:
  using operation = formula::operation;
  using step = formula::step;

  // Enclosure of a step's result, for the points where it is a number.
  struct evaluation {
    interval_jet jet;
    bool may_be_nan = false;  // somewhere in the box
  };

  // False for operations of which no bounds are known.
  static bool is_bounded_operation(operation what);
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
