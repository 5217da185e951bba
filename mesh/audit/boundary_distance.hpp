// SPDX-License-Identifier: MIT
//
// Proves how far the boundary of a mesh is from the one that it took the place of, both ways
// (docs/math/curves.md). From the mesh, its domain and the former boundary alone.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/former_boundary.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Measures the distance. The chords of a curve that is divided are one way, from the curve's one
// end to its other: the former vertices along it are in the list of its first chord, in the
// direction of that, and the lists of its other chords are empty. Any input is taken: what is not
// the boundary of a mesh of the domain is infinitely far.
ASTERISM_EXPORT former_boundary_report measure_former_boundary(const mesh& subject,
                                                               const domain& shape,
                                                               const former_boundary& former);

}  // namespace asterism
