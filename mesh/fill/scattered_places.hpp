// SPDX-License-Identifier: MIT
//
// Visits places all over a box, coarse ones first, finer ones where they are wanted: from these a
// fill begins that has only the boundary's sites. Farthest first, the first few sites would be in
// reach of all of the boundary's, and each of their stars would be made anew for every site inside.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Visits one place in each cell of a quadtree over the box, level by level; whether the cell is cut
// in four is what `visit` answers, given the place and the displacement from the cell's middle to
// its upper right corner. No more than `most` are visited, and none where the box has no extent. A
// place is within half of that displacement from the middle, at a position that depends on the cell
// alone: a lattice would make exact ties. `announce`, where given, is called from time to time with
// the places that come next.
void visit_scattered(
    const bounding_box& box, std::size_t most,
    const std::function<bool(const point& place, const point& half)>& visit,
    const std::function<void(const std::function<std::vector<point>()>& next)>& announce = {});

}  // namespace asterism::internal
