// SPDX-License-Identifier: MIT
//
// Holds the distances and limits that a fill keeps to.
#pragma once

#include <cstddef>

#include "asterism/mesh/fill/prescribed_divisions.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

struct fill_options {
  double distance = 0.75;  // from every point of the domain to the nearest site, metric length
  double longest_subsegment = 0.9;  // of the segments, metric length
  std::size_t max_sites = 100000;
  // True where wanted lengths differ by large factors between a site and its neighbours. All
  // segments are then divided and coarse sites placed inside before any star is made; for a gap
  // without a Voronoi vertex a point of the bisector on the way to the neighbour is proposed.
  bool is_uneven = false;
  // Divisions that segments have already, by segment, which the fill keeps; null if there are none.
  const prescribed_divisions* prescribed = nullptr;
  cancellation stop;  // polled between rounds, and between stars where a round takes long
};

}  // namespace asterism::internal
