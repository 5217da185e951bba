// SPDX-License-Identifier: MIT
//
// Inserts sites into stars: INSERTIONTEST and INSERTSITE of the thesis, section 3.3, restricted to
// the domain.
//
// Differs from the thesis in three ways. Forced neighbours (stars/star.hpp) are never removed, and
// a site on their ray is never inserted. Only sites that v sees inside the domain are inserted. A
// gap closed by a boundary subsegment accepts nothing from the subsegment's outer side. Ties are
// broken in edge_test (predicates/), so that every star breaks a tie the same way.
#pragma once

#include "asterism/mesh/stars/star.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"

namespace asterism::internal {

// True if w passes INSERTIONTEST in the star of v: when the gap is 180 degrees or more (y == x: a
// full turn), when w is strictly inside the triangle v, y, x, or when edge_test accepts it.
// Requires w strictly between its clockwise neighbour y and its counter-clockwise one x, and not in
// the star. Does not test whether v sees w.
bool accepts(const site_oracle& oracle, vertex_index v, vertex_index w, vertex_index y,
             vertex_index x);

// Offers w to the star of v; true if the star changed. If w is accepted, inserts it and removes the
// neighbours on both sides that no longer pass their own test. Removes a neighbour on the same ray
// behind w even if w is not accepted. Requires w != v and w not in the star.
bool offer(const site_oracle& oracle, vertex_index v, star& s, vertex_index w);

// True if offer() would change the star.
bool would_accept(const site_oracle& oracle, vertex_index v, const star& s, vertex_index w);

// Removes neighbours that do not pass their own test against the rest of the star, until all do.
// True if any was removed.
bool prune(const site_oracle& oracle, vertex_index v, star& s);

}  // namespace asterism::internal
