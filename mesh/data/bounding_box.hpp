// SPDX-License-Identifier: MIT
//
// Axis-parallel box.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism {

struct bounding_box {
  point low, high;
};

}  // namespace asterism
