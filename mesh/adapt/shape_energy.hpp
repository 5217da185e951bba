// SPDX-License-Identifier: MIT
//
// Defines the energy of a triangle that a mesh is fitted by. Internal to mesh/adapt.
#pragma once

#include <cmath>
#include <numbers>

#include "asterism/mesh/adapt/editable_mesh.hpp"

namespace asterism::internal::adapting {

inline constexpr double weight_of_size = 0.3, weight_of_low = 0.5;
// Energy of shape from which a triangle counts as poor: every triangle with an angle of 25 degrees
// has at least that.
inline constexpr double poor = 1.5;
// Energy of a triangle's shape in one metric, times twice its area in this metric, over the sum of
// the squares of its sides: 1 if it is equilateral.
inline constexpr double scale_of_shape = 1 / (2 * std::numbers::sqrt3);
// Size of a triangle with edges of length one, as the sum of its corners' roots of the determinant
// times twice the area.
inline constexpr double unit_size = 3 * std::numbers::sqrt3 / 2;

// Returns twice the excess of an energy of shape over that of a poor one, 0 where there is none.
// Has no branch: a triangle may be poor or not, and loops of it are compiled to vector
// instructions.
inline double twice_above_poor(double energy) { return (energy - poor) + std::abs(energy - poor); }

// Returns the energy of a triangle: 1 if it is equilateral with edges of length `unit`, and more
// otherwise. With a unit of 0 the size does not count. Infinite unless the triangle certainly turns
// left.
double shape_energy(const node& a, const node& b, const node& c, double unit);

// Returns the part of the energy that depends on the area, for a triangle that turns left.
double size_energy(const node& a, const node& b, const node& c, double unit);

}  // namespace asterism::internal::adapting
