// SPDX-License-Identifier: MIT
//
// Decides by exact signs whether a point is strictly inside a domain.
#pragma once

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// True if q is strictly inside. `d` must have been accepted by check_domain: only then does the
// number of segments on the way to infinity, internal ones apart, tell inside from outside. A point
// on a segment, internal or not, or on a vertex of one is not inside. `q` finite. Time: O(number of
// segments).
bool contains(const domain& d, const point& q);

}  // namespace asterism::internal
