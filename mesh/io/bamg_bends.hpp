// SPDX-License-Identifier: MIT
//
// Notes that BAMG's geometries, which list edges alone, are taken with straight edges.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// True for the keywords of sections about BAMG's curves: BAMG lays a curve through the vertices of
// its edges, with a common tangent at each vertex that is no corner.
bool is_about_bamg_curves(std::string_view keyword);

// Returns a note on the vertices between two edges that turn there by less than `bound`, in
// degrees, and which are no corners: BAMG has a curve through these. None where there is no such
// vertex. The turn is computed in rounded numbers.
std::optional<std::string> note_of_bamg_bends(const mesh& edges,
                                              const std::vector<vertex_index>& corners,
                                              double bound);

}  // namespace asterism::internal
