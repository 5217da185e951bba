// SPDX-License-Identifier: MIT
//
// Checks that a proof shows the triangles to fill the domain. Part of check_proof(). Both functions
// return the first condition that fails, as an error; nothing if all are shown.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal::proof_detail {

// Checks theorem 1: the triangles fill the rectangle, and the edges listed are the
// mesh's.
std::optional<error> check_filled(const plane& all);
// Checks point 2 against the domain: its vertices, segments, holes and regions; without a domain,
// that triangles with no segment between them have one region.
std::optional<error> check_shape(const plane& all, const proof_question& asked,
                                 const mesh_proof& proof);

}  // namespace asterism::internal::proof_detail
