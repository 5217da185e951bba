// SPDX-License-Identifier: MIT
//
// Maps the parameters of Bezier patches to 0 to 1. Without inner knots a patch has the same points
// whatever its knots are, so that units of its parameters cannot change the mesh.
#pragma once

#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// Returns the surface with knots from 0 to 1 in each direction that has no inner knots, and a note
// for each direction that was changed. Trimmed patches stay unchanged, as their loops are in the
// former units. An invalid surface stays unchanged, to be refused by name.
surface with_unit_patches(surface s);

}  // namespace asterism::internal
