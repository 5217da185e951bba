// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace asterism::internal {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace asterism::internal
