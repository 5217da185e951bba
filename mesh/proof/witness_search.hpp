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

// Returns a meeting that shows that both ends of an inner edge keep the other, for edges without a
// point that shows it.
std::optional<proof_exception> find_edge_meeting(const plane& all, std::uint32_t edge);

// Returns a reason why the gap refuses w, for pairs that the gap's own row does not decide: a
// segment that hides w, another row, or a meeting of this gap or, if w is across the opposite edge,
// of w's gap at that edge.
std::optional<proof_exception> find_exception(const plane& all, std::uint32_t gap, vertex_index w);

}  // namespace asterism::internal::proof_detail
