// SPDX-License-Identifier: MIT
//
// Converts meshes with slits and cracks, whose vertices Python has once for the triangles on each
// side.
#pragma once

#include <utility>

#include "asterism/mesh/domain/cracks.hpp"

namespace asterism::python {

// Returns the mesh with one vertex at each place of a slit, as the mesher and the auditor need it.
// Two vertices at a place without a slit stay two, and a caller that needs a triangulation refuses
// them.
inline std::pair<mesh, crack_markers> joined(mesh m) {
  auto cracks = join_cracks(m);
  return {std::move(m), cracks ? std::move(cracks).value().markers : crack_markers()};
}

}  // namespace asterism::python
