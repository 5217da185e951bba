// SPDX-License-Identifier: MIT
//
// Holds what a fill is to keep to.
#pragma once

#include <cstddef>

#include "asterism/mesh/fill/prescribed_divisions.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

struct fill_options {
  double distance = 0.75;  // from every point of the domain to the nearest site, metric length
  double longest_subsegment = 0.9;  // of the segments, metric length
  std::size_t max_sites = 100000;
  // Set where wanted lengths differ by large factors between a site and its neighbours. All
  // segments are then divided and coarse sites placed inside before any star is made; a gap without
  // a Voronoi vertex proposes a point of the bisector on the way to the neighbour.
  bool is_uneven = false;
  // Divisions that segments have already, which are kept to; null or by segment.
  const prescribed_divisions* prescribed = nullptr;
  cancellation stop;  // polled between rounds, and between stars where a round takes long
};

}  // namespace asterism::internal
