// SPDX-License-Identifier: MIT
//
// Cuts off what segments leave outside of a domain whose boundary they cross. Works inside
// repair_domain.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/domain/snapping.hpp"

namespace asterism::internal {

// Removes chains of pieces that end alone outside or in a hole, and begin at a vertex where the
// segment goes on; pieces meet in vertices alone. Returns the first piece of each chain, whose `a`
// is where it ended.
std::vector<snapped_piece> trim_segments(const domain& d, snapped_graph& graph);

}  // namespace asterism::internal
