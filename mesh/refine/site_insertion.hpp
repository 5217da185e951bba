// SPDX-License-Identifier: MIT
//
// Trying a point as the place of a new site: the conditions of the thesis, section 4.1, shared by
// both heuristics, and the rule for corners that must stay undivided.
#pragma once

#include <cstddef>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/numerics/triangle_quality.hpp"
#include "asterism/mesh/refine/refine_state.hpp"

namespace asterism::internal {

enum class placement_outcome {
  inserted,             // the site is in, or a subsegment it would have encroached on was split
  outside,              // not strictly inside the domain, or the metric field failed there
  too_near,             // not farther than the tolerance from every site, as measured by both
  subsegment_too_short  // would encroach, and no subsegment it encroaches on can be split
};

// Inserts a site at q if it is strictly inside the domain, farther than `tolerance` from every
// site as measured by both, and encroaches on no subsegment. If it would, the subsegments are split
// instead, as far as the tolerance allows; and so is a subsegment that q lies on: right angles
// across from a subsegment have their Voronoi vertex there, and nothing encroaches.
placement_outcome place_site(refine_state& state, const point& q, double tolerance);

// A corner of the domain with an angle of less than twice the bound can have no neighbour between
// its two subsegments: one part would be below the bound. When a bad triangle lies in such a corner
// the remedy is therefore to shorten its subsegments (the longer one, as the corner measures) until
// the triangle between them is small enough to be good and nothing else reaches the corner. Returns
// whether a subsegment was split.
bool shorten_tight_corner(refine_state& state, const triangle& bad, const angle_requirement& angle,
                          double tolerance);

}  // namespace asterism::internal
