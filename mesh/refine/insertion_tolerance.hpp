// SPDX-License-Identifier: MIT
//
// Chooses the least distance between sites at which one may be inserted. The thesis leaves `tol` to
// the user and keeps it fixed.
//
// A given tolerance is kept for Voronoi arcs, and is where darts start. Without one it follows from
// the domain: the arcs start at a fifth of the shortest distance there is before refinement (metric
// length, between two given sites or from a site to a segment not at it; at most 1 with a size
// limit), and halve the distance whenever no candidate can be inserted, ten times at most. Darts
// start at half the median distance of a given site to its nearest neighbour, and shrink it
// themselves: a start from the shortest distance scatters too many sites.
#pragma once

#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/refine/refine_state.hpp"

namespace asterism::internal {

struct tolerance_range {
  double start = 0;
  double floor = 0;
  double shrink = 0.5;  // factor of the arcs' steps; refine/poisson_darts.hpp has its own
  double finest = 0;    // how near sites may have to be because the metric varies; not of darts
};

// Returns the tolerances for the strategy asked for, as metric lengths. `vertices` is the number of
// the domain's vertices, which are the first sites.
tolerance_range choose_tolerance(const refine_state& state, vertex_index vertices,
                                 const mesh_options& options);

}  // namespace asterism::internal
