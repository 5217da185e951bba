// SPDX-License-Identifier: MIT
//
// How near to each other the sites and subsegments of a mesh are: what tolerances are chosen from
// (refine/insertion_tolerance.hpp). In doubles, by searches of what is near; the values are those
// of a look at all pairs, in the same doubles, unless a metric is stretched by more than 2^24.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"

namespace asterism::internal {

// The least of `most` and of the distances from one of the first `count` sites, as it measures, to
// any other one or to a subsegment it is not an end of. `near` knows all sites and subsegments.
double shortest_distance(const std::vector<site>& sites, vertex_index count, const boundary& edges,
                         const neighbourhood& near, double most);

// The median over all sites, at least one, of the distance to the nearest other one, the lesser of
// what the two measure; `most` where that is less. Half the sites are crowded no more than this, so
// darts that far apart can land.
double median_distance(const std::vector<site>& sites, const neighbourhood& near, double most);

}  // namespace asterism::internal
