// SPDX-License-Identifier: MIT
//
// Looks for the witnesses of a proof, in doubles; each is taken only if its conditions are decided
// to hold. Which is found is of no consequence to what it proves.
#pragma once

#include <optional>

#include "asterism/mesh/proof/star_pairs.hpp"

namespace asterism::internal::proof_detail {

// Returns a point at which both ends of an inner edge keep the other.
std::optional<proof_point> find_edge_point(const plane& all, std::uint32_t edge);

// Returns a sound row of three points for the gap, as near to its Voronoi vertex as possible.
std::optional<proof_gap> find_row(const gap_sites& g);
// Returns one of more points, where there is none of three.
std::optional<proof_exception> find_wide_row(const gap_sites& g);

// Returns a reason why the gap refuses w that its own point does not show.
std::optional<proof_exception> find_exception(const plane& all, std::uint32_t gap, vertex_index w);

}  // namespace asterism::internal::proof_detail
