// SPDX-License-Identifier: MIT
//
// Refuses invalid curves before anything is computed with them.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"

namespace asterism::internal {

// Returns the first fault of a curve as it was given (domain/divide_curves.hpp lists them):
// numbers, ends, radius, segment.
std::optional<error> check_curve_values(const domain& d);

}  // namespace asterism::internal
