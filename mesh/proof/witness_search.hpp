// SPDX-License-Identifier: MIT
//
// Searches the witnesses of a proof, in doubles. A witness is accepted only if its conditions are
// decided to hold, so which one is found does not affect what the proof shows.
#pragma once

#include <optional>

#include "asterism/mesh/proof/star_pairs.hpp"

namespace asterism::internal::proof_detail {

// Returns a witness that both ends of an inner edge keep the other.
std::optional<proof_point> find_edge_point(const plane& all, std::uint32_t edge);

// Returns a sound row of three points for the gap, as near to its Voronoi vertex as possible.
std::optional<proof_gap> find_row(const gap_sites& g);
// Returns a sound row of more than three points, for gaps that have none of three.
std::optional<proof_exception> find_wide_row(const gap_sites& g);

// Returns a meeting that shows that both ends of an inner edge keep the other, where it has no such
// point.
std::optional<proof_exception> find_edge_meeting(const plane& all, std::uint32_t edge);

// Returns a reason why the gap refuses w that the gap's own row does not show; or a meeting from
// the other side of the edge across, which shows the same.
std::optional<proof_exception> find_exception(const plane& all, std::uint32_t gap, vertex_index w);

}  // namespace asterism::internal::proof_detail
