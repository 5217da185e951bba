// SPDX-License-Identifier: MIT
//
// Turns triangles so that those with the same corners in the same sense are written alike.
#pragma once

#include <algorithm>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns the triangle turned so that its smallest index comes first; its orientation is kept.
inline triangle canonical(const triangle& t) {
  triangle turned = t;
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
  return turned;
}

}  // namespace asterism::internal
