// SPDX-License-Identifier: MIT
//
// Evaluates a formula in x and y (formula.hpp) in doubles, step by step as it is written. The
// results are the same bits on every machine, as those of elementary.hpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/metric/formula.hpp"

namespace asterism::internal {

class plane_expression {
 public:
  // Reads the formula. Fails with what is wrong and its position (from 1) in `text`.
  static result<plane_expression> parse(const std::string& text);

  // Returns the value, which may be infinite or not a number. Several threads may call it.
  double operator()(const point& q) const;

 private:
  std::vector<formula::step> steps_;
};

}  // namespace asterism::internal
