// SPDX-License-Identifier: MIT
//
// Compares the triangulations of two meshes.
#pragma once

#include <algorithm>

#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// True if both meshes have the same triangles, and the same places of their vertices, in the same
// order.
inline bool is_same_triangulation(const mesh& a, const mesh& b) {
  return a.triangles == b.triangles &&
         std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end(),
                    [](const site& s, const site& t) { return s.position == t.position; });
}

}  // namespace asterism::internal
