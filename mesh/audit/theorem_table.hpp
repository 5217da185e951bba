// SPDX-License-Identifier: MIT
//
// Tabulates the angles that the angle theorem proves: a triangle of three sites within R of their
// Voronoi vertex, no two of them nearer than lambda in both metrics, whose metrics vary by sigma,
// has no smaller angle. Source: docs/math/angle-theorem.md; bench/angle_theorem proves it.
#pragma once

#include <array>
#include <cstddef>

namespace asterism::internal::theorem {

inline constexpr std::array variations = {0.001, 0.005, 0.01,  0.02, 0.03, 0.04,
                                          0.052, 0.058, 0.068, 0.08, 0.1};  // sigma R
inline constexpr std::array ratios = {1.0, 1.1, 1.2, 1.35, 1.5, 1.7};       // R / lambda

// Proved angles in degrees, by variation and ratio.
inline constexpr std::array<std::array<double, ratios.size()>, variations.size()> proved_angles = {{
    {29.75, 26.75, 24.25, 21.5, 19.25, 16.75},
    {29.25, 26.25, 23.75, 21, 18.75, 16.25},
    {28.5, 25.5, 23.25, 20.25, 18, 15.75},
    {27.25, 24.25, 21.75, 19, 16.75, 14.5},
    {25.75, 22.75, 20.5, 17.75, 15.5, 13.25},
    {24.25, 21.5, 19, 16.25, 14.25, 11.75},
    {22.5, 19.75, 17.5, 14.75, 12.5, 10.25},
    {21.75, 18.75, 16.5, 13.75, 11.75, 9.5},
    {20.25, 17.25, 15, 12.25, 10.25, 8},
    {18.25, 15.5, 13.25, 10.5, 8.5, 6.25},
    {14.5, 11.75, 9.75, 6.75, 4.5, 1.75},
}};

// Returns the proved angle, in degrees, of the table's first entry whose variation and ratio are
// both no smaller than these; 0 if none is proved.
constexpr double proved_angle(double variation, double ratio) {
  for (std::size_t i = 0; i < variations.size(); ++i)
    for (std::size_t k = 0; k < ratios.size(); ++k)
      if (variation <= variations[i] && ratio <= ratios[k]) return proved_angles[i][k];
  return 0;
}

}  // namespace asterism::internal::theorem
