// SPDX-License-Identifier: MIT
//
// Checks that the rings of a domain are closed. Works inside check_domain.
//
// A chain of segments that ends alone is no ring. Inside the domain it is an internal segment; in a
// face that is removed it can only be a ring that was meant to be closed, so that its hole or its
// inside is joined to the outside. The error names both ends of the chain: the one that is alone,
// and the other, which is alone as well or joins other segments.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"

namespace asterism::internal {

// Returns an error for the first ring that is not closed. `faces` are those of `graph`, whose edges
// came from `d`; `removed`, by face.
std::optional<error> check_closed(const domain& d, const plane_graph& graph, const face_map& faces,
                                  const std::vector<bool>& removed);

}  // namespace asterism::internal
