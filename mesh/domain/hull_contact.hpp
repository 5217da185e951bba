// SPDX-License-Identifier: MIT
//
// Decides by exact signs whether two convex polygons of few points have a point in common.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Returns the corners of the convex hull, counter-clockwise; one or two points where the hull is a
// point or a segment.
std::vector<point> convex_hull(std::vector<point> points);

// True unless a line along an edge of one of the hulls, as convex_hull returns them, has one hull
// on each side and shows that they have at most a corner in common. If two convex polygons are
// apart, and are not both points, there is such a line.
bool hulls_meet(const std::vector<point>& a, const std::vector<point>& b);

}  // namespace asterism::internal
