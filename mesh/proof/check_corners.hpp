// SPDX-License-Identifier: MIT
//
// Checks that a proof shows the angles to be large enough. Part of check_proof().
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal::proof_detail {

// Point 3. Returns what is not shown.
std::optional<error> check_corners(const plane& all, const proof_question& asked);

}  // namespace asterism::internal::proof_detail
