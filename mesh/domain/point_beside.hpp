// SPDX-License-Identifier: MIT
//
// Finds a point in the face beside a segment.
#pragma once

#include <cstddef>
#include <optional>

#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns a point with nothing between it and the segment, on its left or right: by exact tests the
// triangle that it makes with the segment has no other vertex in it and no segment across. Segments
// meet in common vertices alone. None where doubles have no such point, or the limit on tries is
// reached. O(n) for each try.
std::optional<point> point_beside(const domain& d, std::size_t segment, bool to_left);

}  // namespace asterism::internal
