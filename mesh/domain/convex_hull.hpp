// SPDX-License-Identifier: MIT
//
// Closes a domain by the convex hull of its vertices.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Adds a segment of marker 0 between each two successive vertices on the convex hull, unless the
// domain lists one between them; adds a note with their number. This makes a domain of a set of
// points, as does Triangle's option -c. Exact. Fails where fewer than three vertices are not on one
// line, and for curves, which may reach beyond the vertices.
result<domain> with_convex_hull(domain d);

}  // namespace asterism::internal
