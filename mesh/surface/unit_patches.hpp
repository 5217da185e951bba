// SPDX-License-Identifier: MIT
//
// Takes the parameters of Bezier patches from 0 to 1. Without inner knots a patch has the same
// points whatever its knots are, so that units of its parameters cannot change the mesh.
#pragma once

#include "asterism/mesh/data/surface.hpp"

namespace asterism::internal {

// Returns the surface with the knots of each direction without inner ones from 0 to 1, and a note
// for each that was otherwise. Trimmed patches stay, as their loops are in those units. What is no
// surface stays as it is, to be refused by name.
surface with_unit_patches(surface s);

}  // namespace asterism::internal
