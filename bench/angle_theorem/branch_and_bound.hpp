// SPDX-License-Identifier: MIT
//
// The proof of a row of the angle theorem's table: every configuration of the hypotheses is in a
// box in which the three angles hold.
#pragma once

#include <cstdint>

#include "net_triangle.hpp"

namespace asterism::internal::angle_theorem {

struct proof_attempt {
  bool proved = false;
  std::int64_t boxes = 0;  // judged
  configuration_box last;  // where an attempt without a proof ended
};

// Halves boxes until each is excluded or holds. Gives up after `most_boxes`, or at a box narrower
// than 2^-20: then nothing is proved, nor refuted.
proof_attempt prove(const hypotheses& given, std::int64_t most_boxes);

}  // namespace asterism::internal::angle_theorem
