// SPDX-License-Identifier: MIT
//
// Adds sites for low angles before there are stars, where many sites are given: a proposal, like a
// fill's.
//
// Works on one triangulation (stars/averaged_metric_triangulation.hpp), which takes a site in a few
// microseconds where stars take two hundred. Star refinement repairs whatever it leaves, or
// triangulates differently from the stars. Adds no sites where low angles may be unavoidable.
#pragma once

#include <cstddef>

#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/insertion_tolerance.hpp"
#include "asterism/mesh/refine/refine_state.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// True if prerefinement pays: many vertices are given, and only their angles are to be mended.
bool is_refined_plainly(const mesh_options& options, std::size_t given);

// Adds sites in triangles with an angle below the required one, those with the shortest edges
// first: at their off-centres (refine/off_centre.hpp), or at their Voronoi vertices. No site is
// nearer to others than the tolerance at the start of refinement. Splits subsegments on which these
// sites would encroach. Returns the neighbours that all sites then are likely to have, for
// construct_stars(); nothing where no site could be added. Requires that the state has no stars
// yet.
neighbour_lists refine_plainly(refine_state& state, const angle_requirement& angle,
                               const tolerance_range& tolerance, const cancellation& cancelled);

}  // namespace asterism::internal
