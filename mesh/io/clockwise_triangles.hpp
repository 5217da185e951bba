// SPDX-License-Identifier: MIT
//
// Turns clockwise triangles over, for readers of files and of arrays: programs that do not need an
// orientation write triangles in any.
#pragma once

#include <cstddef>
#include <string_view>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Exchanges two corners of each clockwise triangle, by exact orientations, and adds a note with
// their number. Flat triangles stay. `place` and `from` name the first in the note: "triangle" and
// 1 in files, "row" and 0 in arrays.
void turn_over_clockwise(mesh& m, std::string_view place, std::size_t from);

}  // namespace asterism::internal
