// SPDX-License-Identifier: MIT
//
// Holds the points at which segments of a domain are to be divided, where that was decided before.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// By segment of the domain: the points that divide it, in its direction, ends left out; none where
// the fill decides.
using prescribed_divisions = std::vector<std::optional<std::vector<point>>>;

}  // namespace asterism::internal
