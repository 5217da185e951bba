// SPDX-License-Identifier: MIT
//
// Decides whether a point is inside the domain as its boundary is split.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/stars/boundary.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/stars/star_predicates.hpp"

namespace asterism::internal {

// True if q lies strictly inside the split polygon; false for a point on a subsegment, internal or
// not. Exact. Takes time linear in the number of subsegments, or, with a neighbourhood, in the
// number of those that a ray from q meets.
bool strictly_inside(const boundary& b, const std::vector<site>& sites,
                     const star_predicates& kernel, const point& q,
                     const proximity* near = nullptr);

}  // namespace asterism::internal
