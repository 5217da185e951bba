// SPDX-License-Identifier: MIT
//
// Trying a point as the place of a new site: the conditions of the thesis, section 4.1, shared by
// both heuristics, and the rule for corners that must stay undivided.
#pragma once

#include <cstddef>

#include "asterism/core/site.hpp"
#include "asterism/mesh/mesh.hpp"
#include "asterism/mesh/refine_quality.hpp"
#include "asterism/mesh/refine_state.hpp"

namespace asterism {

enum class placement_outcome {
  inserted,        // the site is in, or a piece it would have encroached on was split
  outside,         // not strictly inside the domain, or the metric field failed there
  too_near,        // not farther than the tolerance from every site, as measured by both
  piece_too_short  // would encroach, and no piece it encroaches on can be split
};

// Inserts a site at q if it is strictly inside the domain, farther than `tolerance` from every
// site as measured by both, and encroaches on no piece. If it would, the pieces are split instead,
// as far as the tolerance allows; and so is a piece that q lies on: right angles across from a
// piece have their Voronoi vertex there, and nothing encroaches.
placement_outcome place_site(refine_state& state, const point& q, double tolerance);

// A corner of the domain with an angle of less than twice the bound can have no neighbour between
// its two pieces: one part would be below the bound. When a bad triangle lies in such a corner the
// remedy is therefore to shorten its pieces (the longer one, as the corner measures) until the
// triangle between them is small enough to be good and nothing else reaches the corner.
// Returns whether a piece was split.
bool shorten_tight_corner(refine_state& state, const triangle& bad, const angle_requirement& angle,
                          double tolerance);

}  // namespace asterism
