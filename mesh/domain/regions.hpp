// SPDX-License-Identifier: MIT
//
// Finds which faces of a plane graph are the domain, and the numbers of its regions. Works inside
// check_domain.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/face_map.hpp"
#include "asterism/mesh/domain/planar_graph.hpp"

namespace asterism::internal {

// Both by face, as face_map names them.
struct domain_parts {
  std::vector<bool> removed;  // the outside, and faces with hole points
  std::vector<int> region;    // of the others
};

// Classifies the faces. `faces` are those of `graph`, whose edges came from `d`. Fails for a hole
// or region point that does not say which face is meant, or contradicts another one.
result<domain_parts> find_parts(const domain& d, const plane_graph& graph, const face_map& faces);

}  // namespace asterism::internal
