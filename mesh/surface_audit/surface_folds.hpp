// SPDX-License-Identifier: MIT
//
// Finds, in doubles, places where the normal of a surface itself turns round abruptly: at a fold or
// a cusp, where every finer mesh is folded too. Proves nothing: it saves attempts to refine there.
#pragma once

#include <array>
#include <optional>

#include "asterism/mesh/surface_audit/net_layout.hpp"

namespace asterism::internal {

// Returns s and t of a place in the part at which normals turn abruptly: normals on its two sides
// differ by more than 90 degrees, as near to the place as doubles distinguish. None where normals
// turn gradually.
std::optional<std::array<double, 2>> fold_in(const bezier_piece& piece,
                                             const parameter_triangle& corners);

}  // namespace asterism::internal
