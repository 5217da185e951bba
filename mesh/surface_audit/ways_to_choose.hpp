// SPDX-License-Identifier: MIT
//
// Returns binomial coefficients, exactly, up to the sum of two degrees of a patch.
#pragma once

#include <array>
#include <cstddef>

#include "asterism/mesh/surface_audit/bezier_pieces.hpp"

namespace asterism::internal {

constexpr std::array<std::array<double, 2 * most_degree + 1>, 2 * most_degree + 1> binomials() {
  std::array<std::array<double, 2 * most_degree + 1>, 2 * most_degree + 1> c{};
  for (std::size_t n = 0; n < c.size(); ++n) {
    c[n][0] = 1;
    for (std::size_t k = 1; k <= n; ++k) c[n][k] = c[n - 1][k - 1] + (k < n ? c[n - 1][k] : 0);
  }
  return c;
}
// Computes exactly: the greatest, C(24, 12), is far below 2^53.
inline constexpr auto binomial = binomials();

inline double ways_to_choose(int n, int k) {
  return binomial[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

}  // namespace asterism::internal
