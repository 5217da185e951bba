// SPDX-License-Identifier: MIT
//
// Defines an axis-parallel box.
#pragma once

#include <algorithm>

#include "asterism/core/site.hpp"

namespace asterism {

// The points between `low` and `high`, both included, coordinate by coordinate.
struct bounding_box {
  point low, high;

  // Enlarges the box to the smallest one that contains the point, or the other box, as well.
  void include(const point& q) {
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
  }
  void include(const bounding_box& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
  }
};

}  // namespace asterism
