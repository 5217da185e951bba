// SPDX-License-Identifier: MIT
//
// Turns clockwise triangles over, for readers of files and of arrays: programs that do not need an
// orientation write triangles in any.
#pragma once

#include <cstddef>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

struct turned_triangles {
  std::size_t count = 0, first = 0;  // the first of them, from 0
};

// Exchanges two corners of each clockwise triangle, by exact orientations. Flat triangles stay.
turned_triangles turn_over_clockwise(mesh& m);

}  // namespace asterism::internal
