// SPDX-License-Identifier: MIT
//
// Points in the holes and regions of a mesh, by which its domain is told from what is not. In
// doubles; whoever uses them compares areas.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Adds a point in each hole of a domain whose boundary segments have it on their left. Returns
// false where segments do not close to rings. Rings may touch at vertices.
bool add_hole_points(domain& shape);

// Adds a point for each part of the mesh between its segments, with its region, where the mesh has
// regions.
void add_region_points(const mesh& m, domain& shape);

double area_of(const mesh& m);
// Returns the area to the left of the boundary segments.
double enclosed_area(const domain& d);

}  // namespace asterism::internal
