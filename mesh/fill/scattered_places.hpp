// SPDX-License-Identifier: MIT
// Visits places all over a box, in coarse cells first and finer cells where they are wanted. A fill
// that has only the boundary's sites begins with these places. If it began farthest first, the
// first few sites would be in reach of all sites of the boundary, and each of these sites' stars
// would be made anew for every site inside.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Visits one place in each cell of a quadtree over the box, level by level. visit(place, half)
// returns whether the cell is to be divided in four; `half` is the displacement from the cell's
// middle to its upper right corner. At most `most` places are visited, and none where the box has
// no extent. A place is within half / 2 of the cell's middle, at a position that depends on the
// cell alone: a lattice would make exact ties. `announce`, where given, is called from time to time
// with a function that returns the places that come next.
void visit_scattered(
    const bounding_box& box, std::size_t most,
    const std::function<bool(const point& place, const point& half)>& visit,
    const std::function<void(const std::function<std::vector<point>()>& next)>& announce = {});

}  // namespace asterism::internal
