// SPDX-License-Identifier: MIT
//
// Holds the points at which segments of a domain must be divided, where another part of the program
// chose them.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Points that divide each segment of the domain, in its direction, ends left out; none where the
// fill chooses them.
using prescribed_divisions = std::vector<std::optional<std::vector<point>>>;

}  // namespace asterism::internal
