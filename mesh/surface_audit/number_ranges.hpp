// SPDX-License-Identifier: MIT
//
// Names the numbers that the auditor in space takes, and the width of bounds that nobody asks for.
#pragma once

namespace asterism::internal {

// Bounds of coordinates, weights and knots that are not 0; others are refused.
inline constexpr double greatest_modulus = 0x1p300, least_modulus = 0x1p-300;

// Is the share of a surface's size to which bounds of a distance are not narrowed further: far
// above what rounding adds, far below any distance that is asked for. The bounds hold whatever it
// is.
inline constexpr double negligible_share = 1e-12;

}  // namespace asterism::internal
