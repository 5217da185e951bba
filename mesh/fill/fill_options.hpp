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
  // Lengths wanted may differ by large factors from one site to its neighbours: all segments are
  // divided and coarse sites put inside before there is a star, and where no Voronoi vertex is
  // found, the bisector on the way to the neighbour will do.
  bool is_uneven = false;
  // Divisions that segments have already, which are kept to; null or by segment.
  const prescribed_divisions* prescribed = nullptr;
  cancellation stop;  // polled between rounds, and between stars where a round takes long
};

}  // namespace asterism::internal
