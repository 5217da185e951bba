// SPDX-License-Identifier: MIT
//
// Finds the domain that a mesh with periodic sides covers.
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/mesh_marks.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"

namespace asterism::internal {

struct periodic_outline {
  mesh_outline found;
  std::vector<int> kept_sides;  // markers of periodic sides that keep all their vertices to match
};

// Finds the domain of the mesh. Periodic sides have no curves, on which a new vertex would have no
// partner on the other side: a side that bends by rounding alone becomes straight, and any other
// side becomes the polygon of its remaining vertices. The outline of a side begins at its
// start, which is the partner of the other side's end, so that partners are dropped one without the
// other even where the metric of both sides is the same. So the vertices that the first side keeps
// are kept on the second; then those that either keeps, on both. If two sides still do not match,
// keeps all vertices of the periodic sides. Without pairs, the outline of the mesh.
result<periodic_outline> outline_with_partners(const mesh& m, mesh_marks marks, outline_options how,
                                               const std::vector<periodic_pair>& pairs);

}  // namespace asterism::internal
