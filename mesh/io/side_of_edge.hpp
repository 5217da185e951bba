// SPDX-License-Identifier: MIT
//
// Identifies a part of the plane by an edge beside it.
#pragma once

#include <cstddef>

namespace asterism {

// A part of the plane beside an edge, and its number.
struct side_of_edge {
  std::size_t edge = 0;  // of mesh::boundary
  bool left = true;      // of the edge as it is listed
  int region = 1;
};

}  // namespace asterism
