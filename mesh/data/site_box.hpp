// SPDX-License-Identifier: MIT
//
// Lists the positions of sites, and finds the box around them or around places.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism::internal {

// Returns the smallest box around all sites; a box of the origin alone when there are none.
inline bounding_box box_of_sites(const std::vector<site>& sites) {
  if (sites.empty()) return {};
  bounding_box box{sites.front().position, sites.front().position};
  for (const site& s : sites) box.include(s.position);
  return box;
}

// Returns the smallest box around all places; a box of the origin alone when there are none.
inline bounding_box box_of_places(const std::vector<point>& places) {
  if (places.empty()) return {};
  bounding_box box{places.front(), places.front()};
  for (const point& q : places) box.include(q);
  return box;
}

// Returns the positions of all sites, in their order.
inline std::vector<point> positions_of(const std::vector<site>& sites) {
  std::vector<point> places;
  places.reserve(sites.size());
  for (const site& s : sites) places.push_back(s.position);
  return places;
}

}  // namespace asterism::internal
