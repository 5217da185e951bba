// SPDX-License-Identifier: MIT
//
// Finds points in the holes and regions of a mesh by which its domain is distinguished from the
// outside. In doubles; users must compare areas.
#pragma once

#include <map>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Adds a point in each hole of a domain whose boundary segments have it on their left. Returns
// false where segments do not close to rings. Rings may touch at vertices.
bool add_hole_points(domain& shape);

// Adds a point for each part of the mesh between its segments, with its region, where the mesh has
// regions.
void add_region_points(const mesh& m, domain& shape);

// Areas in doubles, by the number of the region.
using region_sizes = std::map<int, double>;
region_sizes sizes_of_regions(const mesh& m);
// Returns the areas that the segments enclose. The domain is as check_domain accepts it.
region_sizes enclosed_sizes(const domain& d);

}  // namespace asterism::internal
