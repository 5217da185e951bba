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

// True unless the hulls, as convex_hull returns them, are shown to be apart: by a line along an
// edge of one of them, with one on each side, and nothing in common but at most a corner of both.
// Such a line exists for two convex polygons, with at least one edge between them, that are apart.
bool hulls_meet(const std::vector<point>& a, const std::vector<point>& b);

}  // namespace asterism::internal
