// SPDX-License-Identifier: MIT
//
// Names the numbers that the auditor in space takes, and the width of bounds that nobody asks for.
#pragma once

namespace asterism::internal {

// Bounds of coordinates, weights and knots that are not 0; others are refused.
inline constexpr double greatest_modulus = 0x1p300, least_modulus = 0x1p-300;

// Of the size of everything: far above what rounding adds, far below what anybody asks.
inline constexpr double negligible_share = 1e-12;

}  // namespace asterism::internal
