// SPDX-License-Identifier: MIT
//
// Orders sites along a Hilbert curve, so that sites near each other in the plane are near each
// other in memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns the position of the point on the curve through the box; for a point outside the box that
// of an end of the curve.
inline constexpr int bits_of_place_on_curve = 40;
std::uint64_t place_on_curve(const point& q, const bounding_box& box);

// Returns the numbers of the sites in the order of the curve. It is stable: sites in one cell of
// the finest grid keep their order.
std::vector<std::uint32_t> order_along_curve(const std::vector<site>& sites,
                                             const bounding_box& box);
// Sorts the numbers of some of the sites, or points, into the order of the curve.
void sort_along_curve(std::vector<std::uint32_t>& which, const std::vector<site>& sites,
                      const bounding_box& box);
void sort_along_curve(std::vector<std::uint32_t>& which, const std::vector<point>& points,
                      const bounding_box& box);
// Sorts the sites, or points, into the order of the curve.
void sort_along_curve(std::vector<site>& sites, const bounding_box& box);
void sort_along_curve(std::span<point> points, const bounding_box& box);

}  // namespace asterism::internal
