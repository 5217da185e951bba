// SPDX-License-Identifier: MIT
//
// Tests whether the two curves of each edge of trimmed faces are near enough to each other.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/surface/face_border.hpp"
#include "asterism/mesh/surface/surface_sides.hpp"

namespace asterism::internal {

// Refuses, by name, an edge whose curves are not proved within the chord distance of each other:
// vertices are on one curve alone, so no mesh could be within that distance of both.
std::optional<error> fault_of_gaps(const side_graph& graph, const std::vector<face_border>& borders,
                                   const std::vector<bezier_piece>& pieces,
                                   const std::vector<patch_spans>& spans, double chord);

}  // namespace asterism::internal
