// SPDX-License-Identifier: MIT
//
// Proves a row of the angle theorem's table: covers the configurations that meet the hypotheses
// with boxes in which all three angles reach the bound.
#pragma once

#include <cstdint>

#include "net_triangle.hpp"

namespace asterism::internal::angle_theorem {

struct proof_attempt {
  bool proved = false;
  std::int64_t boxes = 0;  // boxes judged
  configuration_box last;  // the box at which an attempt ended without a proof
};

// Halves boxes until in each the hypotheses fail or the angles reach the bound. Gives up after
// `most_boxes`, or at a box narrower than 2^-20: nothing is then proved, nor refuted.
proof_attempt prove(const hypotheses& given, std::int64_t most_boxes);

}  // namespace asterism::internal::angle_theorem
