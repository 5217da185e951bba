// SPDX-License-Identifier: MIT
//
// Adds sites for low angles before there are stars, where many sites are given: a proposal, like a
// fill's.
//
// Works on one triangulation (stars/mean_metric_net.hpp), which takes a site in a few microseconds
// where stars take two hundred. What it leaves, or does that stars would not have, is mended by
// them as ever. Adds nothing on the boundary, nor where low angles may have to stay.
#pragma once

#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Adds sites, none nearer than the tolerance to others, at Voronoi vertices of triangles with an
// angle below what is required, the worst first. Returns the neighbours that all sites then are
// likely to have, for construct_stars(); nothing where nothing could be done. Requires that the
// state has no stars yet.
neighbour_lists refine_plainly(refine_state& state, const angle_requirement& angle,
                               double tolerance, const cancellation& cancelled);

}  // namespace asterism::internal
