// SPDX-License-Identifier: MIT
//
// Closes a domain by the convex hull of its vertices.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Adds the sides of the convex hull of the vertices as segments of marker 0, between all vertices
// that are on it, where none is listed between the two. Notes how many. A set of points becomes a
// domain so, as by Triangle's option -c. Exact. Fails where fewer than three vertices are not on
// one line, and for curves, which may reach beyond the vertices.
result<domain> with_convex_hull(domain d);

}  // namespace asterism::internal
