// SPDX-License-Identifier: MIT
//
// Computes boxes around the points near a site in its metric. In doubles, for searches.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism::internal {

// Returns a box around the points that could encroach on the subsegment between a and b as
// long as metrics vary moderately within its length: a heuristic of refinement, without a
// guarantee.
bounding_box influence_box(const site& a, const site& b);

// Returns a box around all points within `distance` of the site, as it measures. Not rigorous:
// rounding may leave out points at the rim.
bounding_box box_around(const site& s, double distance);

}  // namespace asterism::internal
