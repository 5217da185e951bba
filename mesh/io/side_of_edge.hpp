// SPDX-License-Identifier: MIT
//
// Names a part of the plane by an edge beside it.
#pragma once

#include <cstddef>

namespace asterism {

// The part of the plane on one side of an edge, and its number.
struct side_of_edge {
  std::size_t edge = 0;  // of mesh::boundary
  bool left = true;      // of the edge as it is listed
  int region = 1;
};

}  // namespace asterism
