// SPDX-License-Identifier: MIT
//
// Finds, in doubles, places where a surface itself turns round abruptly: at a fold or a cusp, over
// which no finer mesh lies unfolded. It proves nothing: it saves attempts to refine there.
#pragma once

#include <array>
#include <optional>

#include "asterism/mesh/surface_audit/net_layout.hpp"

namespace asterism::internal {

// Returns s and t of a place of the piece where normals on both sides are more than 90 degrees
// apart as near to it as doubles tell, between places of the part; none where they turn evenly.
std::optional<std::array<double, 2>> fold_in(const bezier_piece& piece,
                                             const parameter_triangle& corners);

}  // namespace asterism::internal
