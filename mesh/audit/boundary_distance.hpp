// SPDX-License-Identifier: MIT
//
// Proves an upper bound of the distance, both ways, between the boundary of a mesh and the former
// boundary that its domain was made of (docs/math/curves.md). Uses the mesh, its domain and the
// former boundary alone.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/former_boundary.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Measures the distance between the mesh's boundary and the former one, in units of the domain. The
// chords of a divided curve are taken together, from one end of the curve to the other: `former`
// lists the vertices along it for its first chord, in that chord's direction, and none for its
// other chords. Accepts any input: for a mesh that is none of the domain the distance is infinite.
ASTERISM_EXPORT former_boundary_report measure_former_boundary(const mesh& subject,
                                                               const domain& shape,
                                                               const former_boundary& former);

}  // namespace asterism
