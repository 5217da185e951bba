// SPDX-License-Identifier: MIT
//
// Looks for the weights that show what happens where the bisectors of four sites meet.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/proof/meeting.hpp"

namespace asterism::internal::proof_detail {

// Returns weights with which `is_edge_at_meeting` holds. Where all four bisectors have a point in
// common they are exact; elsewhere they are rounded, to the digits that `is_edge_at_meeting` needs.
std::optional<std::vector<whole>> find_weights(const meeting_sites& sites, const meeting_box& box);

}  // namespace asterism::internal::proof_detail
