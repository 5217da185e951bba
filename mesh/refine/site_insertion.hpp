// SPDX-License-Identifier: MIT
//
// Tries a point as the place of a new site by the conditions of the thesis, section 4.1, which both
// heuristics share. Shortens the subsegments at corners that must stay undivided.
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

// Inserts a site at q if it is strictly inside the domain, farther than `tolerance` from every site
// as measured by both, and encroaches on no subsegment. If it would encroach, the subsegments are
// split instead, as far as the tolerance allows. A subsegment that q lies on is split too: the
// Voronoi vertex of a right triangle lies on the subsegment opposite the right angle, on which no
// site then encroaches.
placement_outcome place_site(refine_state& state, const point& q, double tolerance);

// Splits a subsegment at a corner of the domain in which the bad triangle lies, if the corner's
// angle is below twice the angle bound; true if one was split. Such a corner can have no neighbour
// between its two subsegments: one part of the angle would be below the bound. The remedy is
// therefore to shorten its subsegments (the longer one first, as the corner measures) until the
// triangle between them is small enough to be good and no other site is a neighbour of the corner.
bool shorten_tight_corner(refine_state& state, const triangle& bad, const angle_requirement& angle,
                          double tolerance);

}  // namespace asterism::internal
