// SPDX-License-Identifier: MIT
//
// Meshes with slits and cracks, whose vertices Python has once for the triangles on each side.
#pragma once

#include <utility>

#include "asterism/mesh/domain/cracks.hpp"

namespace asterism::python {

// Returns the mesh as the mesher and the auditor have it, with one vertex at each place of a slit.
// One that has two where no slit is stays so, and is refused by who asks for a triangulation.
inline std::pair<mesh, crack_markers> joined(mesh m) {
  auto cracks = join_cracks(m);
  return {std::move(m), cracks ? std::move(cracks).value().markers : crack_markers()};
}

}  // namespace asterism::python
