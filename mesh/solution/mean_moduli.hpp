// SPDX-License-Identifier: MIT
//
// Averages the moduli of second derivatives over the triangles around each vertex.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Returns, for each vertex, the mean of |H| over the triangles at it, by area, where |H| of a
// triangle is the mean of its corners', and has the moduli of H's eigenvalues. The error of a
// triangle depends on |H| all over it; H from one ring of triangles nearly vanishes on the line
// where a front is steepest, and is greatest one triangle beside it, so that without the mean the
// triangles between would stay too large. Signs are removed before the mean: with them a wave's two
// halves would cancel. Vertices of the boundary keep their own |H|: a mean with the inside would
// weaken a layer at a wall, and a corner.
std::vector<metric_tensor> mean_moduli(const mesh& m, const mesh_links& links,
                                       const std::vector<metric_tensor>& hessian);

}  // namespace asterism::internal
