// SPDX-License-Identifier: MIT
//
// The order of a Hilbert curve: sites near each other in the plane come near each other in memory.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Stable: sites in one cell of the finest grid keep their order.
void sort_along_curve(std::vector<site>& sites, const bounding_box& box);

}  // namespace asterism::internal
