// SPDX-License-Identifier: MIT
//
// Looks whether the two curves of each edge of trimmed faces are near enough for what is asked.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/surface/face_border.hpp"
#include "asterism/mesh/surface/surface_sides.hpp"

namespace asterism::internal {

// Refuses, by name, an edge whose curves are not proved within the distance asked of each other:
// vertices are on one of them, so that no mesh can be.
std::optional<error> fault_of_gaps(const side_graph& graph, const std::vector<face_border>& borders,
                                   const std::vector<bezier_piece>& pieces,
                                   const std::vector<patch_spans>& spans, double chord);

}  // namespace asterism::internal
