// SPDX-License-Identifier: MIT
//
// Axis-parallel box.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism {

// The points between `low` and `high`, both included, coordinate by coordinate.
struct bounding_box {
  point low, high;
};

}  // namespace asterism
