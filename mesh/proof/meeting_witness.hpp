// SPDX-License-Identifier: MIT
//
// Looks up, among the exceptions of a proof, what meetings show of edges and of gaps.
#pragma once

#include <span>

#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"

namespace asterism::internal::proof_detail {

// Added to the turn of a meeting's row if the row belongs to the opposite gap, in the star of the
// site beyond the edge, and not to the gap named. No row has this number of points.
inline constexpr std::uint8_t turn_by_site = 128;

// Returns the exception of the gap and the site, or null. Exceptions must be sorted by site and
// gap.
const proof_exception* exception_of(std::span<const proof_exception> exceptions, std::uint32_t gap,
                                    vertex_index w);

// Returns the gap on the other side of the edge opposite a gap's centre, or none if no triangle of
// the mesh is there.
std::uint32_t gap_behind(const plane& all, std::uint32_t gap);

// True if the ends of an inner edge are shown to keep each other by a meeting of one of the two
// gaps beside the edge.
bool is_kept_at_meeting(const plane& all, std::span<const proof_exception> exceptions,
                        std::uint32_t edge);

// True if a meeting shows that the gap refuses w: one of this gap with w, or, if w is the centre of
// the gap behind, one of that gap with the centre of this one.
bool is_refused_at_meeting(const plane& all, std::span<const proof_exception> exceptions,
                           std::uint32_t gap, vertex_index w);

}  // namespace asterism::internal::proof_detail
