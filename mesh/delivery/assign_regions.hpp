// SPDX-License-Identifier: MIT
//
// Assigns a region to every triangle of a mesh, from the segments of its domain.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Sets `m.regions`: empty when region 1 is the domain's only one, else one for each triangle. The
// triangles beside a segment have the region the domain has there; from them it spreads to their
// neighbours, as far as the next segment. `d` is the domain `m` is a mesh of, accepted by
// check_domain. In a mesh with gaps a triangle that is reached from no segment has 0. O(n log
// n).
void assign_regions(mesh& m, const domain& d);

}  // namespace asterism::internal
