// SPDX-License-Identifier: MIT
//
// Defines the range of numbers that the auditor in space accepts, and the width of bounds at which
// it stops by default.
#pragma once

namespace asterism::internal {

// Bounds of coordinates, weights and knots that are not 0; others are refused.
inline constexpr double greatest_modulus = 0x1p300, least_modulus = 0x1p-300;

// Ends the narrowing of bounds of a distance that are below this share of the surface's
// size: far above rounding errors, far below any useful distance. Bounds are valid for any
// value.
inline constexpr double negligible_share = 1e-12;

}  // namespace asterism::internal
