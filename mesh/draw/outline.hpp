// SPDX-License-Identifier: MIT
//
// Makes a mesh without triangles from a domain, for pictures and pages.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns the domain's vertices as given sites with the plane metric, and its segments as boundary
// edges. The domain need not be checked: segments that name no vertex are left out. Polygons are
// shown by their rings; of curves the chords alone: divide_curves makes more of them.
mesh outline_of(const domain& d);

}  // namespace asterism::internal
