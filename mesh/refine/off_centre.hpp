// SPDX-License-Identifier: MIT
//
// Finds a place for a site near the shortest edge of a triangle with low angles: where that edge is
// seen under a given angle, on the way to the Voronoi vertex. Sites placed so stay clear of long
// subsegments next to short ones, as there are at the tips of narrow wedges, and sizes grow away
// from the tip as fast as the bound allows. Source: Alper Üngör, "Off-centers: a new type of
// Steiner points for computing size-optimal quality-guaranteed Delaunay triangulations", LATIN
// 2004, there for one metric; here in the mean of those of the edge's ends.
#pragma once

#include <optional>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/refine/refine_state.hpp"

namespace asterism::internal {

// Returns the point on the inner side of the shortest edge, equally far from its ends, that sees it
// under `degrees`; none if the Voronoi vertex of the triangle, which is `radius` from its sites, is
// nearer to the edge.
std::optional<point> off_centre(const triangle_sites& s, double degrees, double radius);

// Returns a site that sees the shortest edge of the triangle under `degrees`. None if the Voronoi
// vertex is nearer to the edge, or the site would not be strictly inside, farther than `tolerance`
// from every site as both measure, and encroaching on nothing. In doubles except for these
// conditions.
std::optional<site> find_off_centre(refine_state& state, const triangle& t, double degrees,
                                    double tolerance);

}  // namespace asterism::internal
