// SPDX-License-Identifier: MIT
//
// Holds a polygon with holes, as GeoJSON, well-known text and similar formats define it, by the
// segments of a domain. Where a domain has polygons, a point on no segment belongs to it if one of
// them contains it: if the outer ring encloses it and none of this polygon's own holes does. A hole
// takes nothing away from another polygon.
//
// Source: OGC 06-103r4, section 6.1.11; RFC 7946, section 3.1.6.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace asterism {

// A polygon of a domain. A ring encloses the points that are separated from infinity by an odd
// number of its segments: of a ring that meets itself, or was repaired, this is what is inside.
struct domain_polygon {
  // Number of the feature that the polygon belongs to. Where polygons of several features have a
  // part of the domain in common, its region is the least of their numbers. Without a number, the
  // part is numbered like one without a region point.
  std::optional<int> region;
  // Indices of each ring's segments: the outer ring's first, then those of holes. A polygon without
  // rings contains nothing.
  std::vector<std::vector<std::uint32_t>> rings;
};

}  // namespace asterism
