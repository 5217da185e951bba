// SPDX-License-Identifier: MIT
//
// Finds the vertices of a divided domain at which its curves continue without a corner: files mark
// the others as corners.
#pragma once

#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns, ascending, the vertices that end two segments, both chords of curves, whose directions
// there are the same but for roundings.
ASTERISM_EXPORT std::vector<vertex_index> smooth_vertices(const domain& d);

}  // namespace asterism::internal
