// SPDX-License-Identifier: MIT
//
// Weighs an exact answer, in the units of work_units.hpp beyond those of an ordinary one, by how
// far the numbers of the question lie apart, and by whether its metrics differ. Beyond the
// exponents of doubles the searches in doubles that make exact answers fast find nothing. Measured
// on edge tests of thin tensors: 0.1 to 0.3 ms up to condition 1e300, 45 to 100 ms from 1e400 to
// 1e600. Where tensors differ in all their bits the polynomials are of full degree, and take 1 to
// 2.5 ms in the stars of meshes of random tensors. Metrics of which meshes are made lie far below
// either bound: condition 1e16 with coordinates as small as rounding leaves them takes 170
// exponents.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// The binary exponents from the least to the greatest of those numbers that are not zero.
class exponent_range {
 public:
  void cover(double x) {
    if (x == 0) return;
    const int exponent = std::ilogb(x);
    low_ = empty_ ? exponent : std::min(low_, exponent);
    high_ = empty_ ? exponent : std::max(high_, exponent);
    empty_ = false;
  }
  int width() const { return high_ - low_; }

 private:
  bool empty_ = true;
  int low_ = 0, high_ = 0;
};

// Returns the extra weight. The exponents of tensor entries count once, those of coordinates, which
// are squared, twice.
template <std::size_t Count>
std::uint64_t spread_weight(const std::array<const site*, Count>& sites) {
  constexpr int wide = 300, too_wide = 1022;  // 2^-1022 is the least double of full precision
  constexpr std::uint64_t weight_of_different = 200, weight_of_wide = 20,
                          weight_of_too_wide = 10000;
  exponent_range tensors, coordinates;
  for (const site* s : sites) {
    for (const double x : {s->metric.m11, s->metric.m12, s->metric.m22}) tensors.cover(x);
    for (const double x : {s->position.x, s->position.y}) coordinates.cover(x);
  }
  const int width = tensors.width() + 2 * coordinates.width();
  if (width > too_wide) return weight_of_too_wide;
  const bool are_different = std::any_of(sites.begin(), sites.end(), [&](const site* s) {
    return !identical(s->metric, sites[0]->metric);
  });
  return (are_different ? weight_of_different : 0) + (width > wide ? weight_of_wide : 0);
}

}  // namespace asterism::internal
