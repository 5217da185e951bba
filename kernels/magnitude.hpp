// SPDX-License-Identifier: MIT
//
// Brings sites into a range where degree 20 neither overflows nor vanishes. Every predicate keeps
// its answer when all coordinates, and separately all metrics, are multiplied by a power of two;
// the scaling is done only when it is exact.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "asterism/core/site.hpp"

namespace asterism::internal {

namespace magnitude {

// Largest exponent without scaling: (2^40)^20 is far below the largest double.
inline constexpr double low = 0x1p-40, high = 0x1p40;

struct extent {
  double coordinate = 0, metric = 0;

  void cover(const point& p) {
    coordinate = std::fmax(coordinate, std::fmax(std::abs(p.x), std::abs(p.y)));
  }
  void cover(const metric_tensor& m) {
    metric =
        std::fmax(metric, std::fmax(std::abs(m.m11), std::fmax(std::abs(m.m12), std::abs(m.m22))));
  }
  static bool harmless(double x) { return (x >= low && x <= high) || x == 0; }
  bool harmless() const { return harmless(coordinate) && harmless(metric); }
};

// Returns x * 2^shift, clearing `exact` when bits are lost.
inline double scale(double x, int shift, bool& exact) {
  const double scaled = std::scalbn(x, shift);
  if (std::scalbn(scaled, -shift) != x) exact = false;
  return scaled;
}

inline int shift_for(double x) { return extent::harmless(x) ? 0 : -std::ilogb(x); }

inline point scale(const point& p, int shift, bool& exact) {
  return {scale(p.x, shift, exact), scale(p.y, shift, exact)};
}
inline metric_tensor scale(const metric_tensor& m, int shift, bool& exact) {
  return {scale(m.m11, shift, exact), scale(m.m12, shift, exact), scale(m.m22, shift, exact)};
}

}  // namespace magnitude

// The sites and points of one question, scaled into the range above; `usable` is false when no
// exact scaling brings them there.
template <std::size_t Sites, std::size_t Points>
struct scaled_input {
  std::array<site, Sites> sites;
  std::array<point, Points> points;
  bool usable = true;

  scaled_input(const std::array<const site*, Sites>& given,
               const std::array<const point*, Points>& at) {
    magnitude::extent extent;
    for (std::size_t k = 0; k < Sites; ++k) {
      sites[k] = *given[k];
      extent.cover(sites[k].position);
      extent.cover(sites[k].metric);
    }
    for (std::size_t k = 0; k < Points; ++k) {
      points[k] = *at[k];
      extent.cover(points[k]);
    }
    if (extent.harmless()) return;
    const int coordinate_shift = magnitude::shift_for(extent.coordinate);
    const int metric_shift = magnitude::shift_for(extent.metric);
    for (site& s : sites)
      s = {magnitude::scale(s.position, coordinate_shift, usable),
           magnitude::scale(s.metric, metric_shift, usable)};
    for (point& p : points) p = magnitude::scale(p, coordinate_shift, usable);
  }
};

}  // namespace asterism::internal
