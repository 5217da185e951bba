// SPDX-License-Identifier: MIT
//
// Names the numbers that the auditor in space takes, and the width of bounds that nobody asks for.
#pragma once

namespace asterism::internal {

// Bounds of coordinates, weights and knots that are not 0; others are refused.
inline constexpr double greatest_modulus = 0x1p300, least_modulus = 0x1p-300;

// Ends the narrowing of bounds of a distance that are below this share of the surface's size: far
// above what rounding adds, far below any distance that is asked for. Chosen; bounds hold whatever
// it is.
inline constexpr double negligible_share = 1e-12;

}  // namespace asterism::internal
