// SPDX-License-Identifier: MIT
//
// Defines the range of numbers that the auditor in space accepts, and the width of bounds at which
// it stops by default.
#pragma once

namespace asterism::internal {

// Bounds of coordinates, weights and knots that are not 0; others are refused.
inline constexpr double greatest_modulus = 0x1p300, least_modulus = 0x1p-300;

// Share of the surface's size below which bounds of a distance are not narrowed further: far above
// rounding errors, far below any useful distance. Bounds are valid for any value.
inline constexpr double negligible_share = 1e-12;

}  // namespace asterism::internal
