// SPDX-License-Identifier: MIT
//
// Checks the numbers of a domain, before its shape is examined.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns an error for the first coordinate that is not finite, for a segment whose vertices do not
// exist, for too many vertices, and where there are no segments.
std::optional<error> check_domain_values(const domain& d);

}  // namespace asterism::internal
