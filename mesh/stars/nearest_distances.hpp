// SPDX-License-Identifier: MIT
//
// Measures how near to each other the sites and subsegments of a mesh are, for the choice of
// tolerances (refine/insertion_tolerance.hpp). Works in doubles and searches only near sites and
// subsegments. The values are those of a search of all pairs in the same doubles, unless a metric
// is stretched by more than 2^24.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"

namespace asterism::internal {

// Returns the shortest distance from one of the first `count` sites, as it measures, to any other
// site or to a subsegment that it is not an end of; at most `most`. `near` must know all sites and
// subsegments.
double shortest_distance(const std::vector<site>& sites, vertex_index count, const boundary& edges,
                         const proximity& near, double most);

// Returns the median over all sites of the distance to the nearest other site, each at most `most`.
// The distance of two sites is the lesser of what both measure. Requires at least one site. Half of
// the sites have no other site nearer than this, so that darts at this distance from each other
// find room.
double median_distance(const std::vector<site>& sites, const proximity& near, double most);

}  // namespace asterism::internal
