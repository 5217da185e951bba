// SPDX-License-Identifier: MIT
//
// Removes the parts of segments that cross the boundary of a domain and end outside of it. Works
// inside repair_domain.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/snapping.hpp"

namespace asterism::internal {

// Removes chains of pieces that end alone outside or in a hole, and begin at a vertex where the
// segment goes on; pieces meet in vertices alone. Returns the first piece of each chain, whose end
// `a` is the free one.
std::vector<snapped_piece> trim_segments(const domain& d, snapped_graph& graph);

}  // namespace asterism::internal
