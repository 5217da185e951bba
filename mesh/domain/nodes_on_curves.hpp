// SPDX-License-Identifier: MIT
//
// Finds where the nodes of second-order triangles lie on the curves of a domain.
#pragma once

#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/side_nodes.hpp"

namespace asterism::internal {

// Returns, ascending by their ends, a node for each subsegment whose two ends are on the curve that
// its segment is a chord of: the point of the curve beside the middle. `shape` is the domain that
// the boundary's segments are numbered in, which check_domain has accepted. Proposes in doubles:
// the auditor proves (audit/curved_triangles.hpp).
ASTERISM_EXPORT std::vector<side_node> nodes_on_curves(const mesh& m, const domain& shape);

}  // namespace asterism::internal
