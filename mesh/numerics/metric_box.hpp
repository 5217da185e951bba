// SPDX-License-Identifier: MIT
//
// Computes boxes around the points that are near as a metric measures. In doubles, for searches.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism::internal {

// Returns a box around the points that could encroach on the subsegment between a and b when
// metrics do not vary beyond all measure within its length: a policy of refinement, nothing
// certain.
bounding_box influence_box(const site& a, const site& b);

// Returns a box around all points within `distance` of the site, as it measures. Not rigorous:
// rounding may leave out points at the rim.
bounding_box box_around(const site& s, double distance);

}  // namespace asterism::internal
