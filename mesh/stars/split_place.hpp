// SPDX-License-Identifier: MIT
//
// Decides whether a subsegment of the boundary can be split at a point without harm to its
// surroundings.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

// True if m lies in the box of the subsegment a b (anywhere, if it is on a curve), is neither of
// its ends, and replacing a b by a m, m b leaves every other site and subsegment where it was: on
// the same side of the boundary, uncrossed and untouched. Only the sliver a, m, b changes sides.
// Where segments meet in a sharp corner, or a few ulps apart, m may be rounded onto another
// segment. Exact.
bool leaves_others_in_place(const star_predicates& kernel, const std::vector<site>& sites,
                            const boundary& edges, const proximity& near,
                            const boundary_edge& subsegment, const point& m, bool on_curve = false);

}  // namespace asterism::internal
