// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns the region of triangle t: a mesh without a list of them is all in region 1.
inline int region_of(const mesh& m, std::size_t t) { return m.regions.empty() ? 1 : m.regions[t]; }

}  // namespace asterism::internal
