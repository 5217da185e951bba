// SPDX-License-Identifier: MIT
//
// Looks up, among the exceptions of a proof, what meetings show of edges and of gaps.
#pragma once

#include <span>

#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"

namespace asterism::internal::proof_detail {

// Marks, added to the turn of a meeting's row, a row around the gap in the star of the site beyond
// the edge, which faces the gap named. No row has as many points.
inline constexpr std::uint8_t turn_by_site = 128;

// Returns the exception of the gap and the site, or null. Exceptions must be sorted by site and
// gap.
const proof_exception* exception_of(std::span<const proof_exception> exceptions, std::uint32_t gap,
                                    vertex_index w);

// Returns the gap on the other side of the edge across from a gap, or none where that has no
// triangle of the mesh.
std::uint32_t gap_behind(const plane& all, std::uint32_t gap);

// True if a meeting of one of the gaps on both sides of an inner edge shows that its ends keep each
// other.
bool is_kept_at_meeting(const plane& all, std::span<const proof_exception> exceptions,
                        std::uint32_t edge);

// True if a meeting shows that the gap refuses w, its own or that of the gap behind, whose centre w
// is: that refuses the centre of this one.
bool is_refused_at_meeting(const plane& all, std::span<const proof_exception> exceptions,
                           std::uint32_t gap, vertex_index w);

}  // namespace asterism::internal::proof_detail
