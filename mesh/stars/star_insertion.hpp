// SPDX-License-Identifier: MIT
//
// INSERTIONTEST and INSERTSITE of the thesis, section 3.3, restricted to the domain.
//
// Three additions to the thesis. Forced neighbours (stars/star.hpp) are never removed, and a site
// on their ray is never inserted. Only sites that v sees inside the domain are inserted. A gap
// closed by a boundary subsegment accepts nothing from the subsegment's outer side. The
// tie-breaking is in edge_test (predicates/), so that every star breaks a tie the same way.
#pragma once

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

// INSERTIONTEST for w strictly between its clockwise neighbour y and its counter-clockwise one x
// in the star of v, which does not contain w. Yes when the gap is 180 degrees or more (y == x: a
// full turn), when w is strictly inside the triangle v, y, x, or when edge_test says so.
// Does not ask whether v sees w.
bool accepts(const site_oracle& oracle, vertex_index v, vertex_index w, vertex_index y,
             vertex_index x);

// Offers w to the star of v: tests it and, when it is accepted, inserts it and removes the
// neighbours on both sides that no longer pass their own test. A neighbour on the same ray behind
// w is removed even when w is not accepted. Returns whether the star changed.
// Requires w != v and w not in the star.
bool offer(const site_oracle& oracle, vertex_index v, star& s, vertex_index w);

// Whether offer() would change the star.
bool would_accept(const site_oracle& oracle, vertex_index v, const star& s, vertex_index w);

// Removes neighbours that do not pass their own test against the rest of the star, until all do.
// Returns whether any was removed.
bool prune(const site_oracle& oracle, vertex_index v, star& s);

}  // namespace asterism::internal
