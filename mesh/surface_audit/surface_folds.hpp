// SPDX-License-Identifier: MIT
//
// Finds, in doubles, places where a surface itself turns round abruptly: at a fold or a cusp, over
// which no finer mesh lies unfolded. It proves nothing: it saves attempts to refine there.
#pragma once

#include <array>
#include <optional>

#include "asterism/mesh/surface_audit/net_layout.hpp"

namespace asterism::internal {

// Returns s and t of a place in the part at which normals turn abruptly: those on both sides differ
// by more than 90 degrees as near to it as doubles distinguish. None where normals turn gradually.
std::optional<std::array<double, 2>> fold_in(const bezier_piece& piece,
                                             const parameter_triangle& corners);

}  // namespace asterism::internal
