// SPDX-License-Identifier: MIT
//
// Checks that a proof shows every angle to be at least the bound. Part of check_proof().
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal::proof_detail {

// Checks point 3 of docs/math/proof-format.md. Returns the first triangle that fails, as an error;
// nothing if the point is shown.
std::optional<error> check_corners(const plane& all, const proof_question& asked);

}  // namespace asterism::internal::proof_detail
