// SPDX-License-Identifier: MIT
//
// Checks that a proof shows the triangles to fill the domain. Part of check_proof().
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal::proof_detail {

// Both return what is not shown.
// Theorem 1: the triangles fill the rectangle, and the edges listed are the mesh's.
std::optional<error> check_filled(const plane& all);
// Point 2 against the domain: its vertices, its segments, its holes and regions; without one, that
// triangles with no segment between them have one region.
std::optional<error> check_shape(const plane& all, const proof_question& asked,
                                 const mesh_proof& proof);

}  // namespace asterism::internal::proof_detail
