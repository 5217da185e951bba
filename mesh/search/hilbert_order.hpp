// SPDX-License-Identifier: MIT
//
// Orders sites along a Hilbert curve, so that sites near each other in the plane are near each
// other in memory.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns the order. It is stable: sites in one cell of the finest grid keep their order.
void sort_along_curve(std::vector<site>& sites, const bounding_box& box);

}  // namespace asterism::internal
