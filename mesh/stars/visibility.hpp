// SPDX-License-Identifier: MIT
//
// Decides which sites see each other inside the domain: only these may be neighbours in a star.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

// True if the open segment between sites v and w stays off the boundary: it crosses no subsegment
// and passes through no boundary vertex. (A segment through a boundary vertex could never be an
// edge of a mesh that has that vertex, whichever side it continues on.) If v is on the boundary,
// requires w to lie strictly inside one of v's corners: the star itself handles the corner at v.
// Exact. Takes time linear in the number of subsegments, or, with a neighbourhood, of those near
// the segment.
bool sees(const boundary& b, const std::vector<site>& sites, const star_predicates& kernel,
          vertex_index v, vertex_index w, const proximity* near = nullptr);

// True if the open segments p q and r s cross in one point interior to both. Exact.
bool properly_cross(const star_predicates& kernel, const point& p, const point& q, const point& r,
                    const point& s);

// True if q, known to be on the line through p and r, lies strictly between them.
bool strictly_between(const point& p, const point& q, const point& r);

// True if `at` lies on the segment p q and is no end of it. Exact.
bool on_open_segment(const star_predicates& kernel, const point& p, const point& q,
                     const point& at);

}  // namespace asterism::internal
