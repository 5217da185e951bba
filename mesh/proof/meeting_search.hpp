// SPDX-License-Identifier: MIT
//
// Looks, in doubles, for the box and the row of a witness where the bisectors of four sites meet.
#pragma once

#include <optional>

#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"

namespace asterism::internal::proof_detail {

// Returns a meeting of a gap and a site beyond it, which shows that the ends of the gap keep each
// other; with `is_refused` its row shows, too, that the gap refuses the site. With `is_by_site` the
// meeting is that of the gap from y to x in the star of the site, with the centre of the given gap
// as the site beyond it.
std::optional<proof_exception> find_meeting(const plane& all, std::uint32_t gap, vertex_index w,
                                            bool is_refused, bool is_by_site = false);

}  // namespace asterism::internal::proof_detail
