// SPDX-License-Identifier: MIT
//
// Computes a projection without new extrema.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/mass_matrix.hpp"

namespace asterism::internal {

// Returns values near the projection x of b that stay, at every vertex, within the old field's
// values in the triangles around it. The lumped projection b / (row sum) is a mean of such values,
// and both have one integral; they differ by fluxes along edges, m_ij (x_i - x_j), each of which is
// limited to the greatest part that keeps both its ends within bounds (Zalesak's limiter). The
// outflow of one end is the inflow of the other, so that the integral stays. Source: Farrell et
// al., "Conservative interpolation between unstructured meshes via supermesh construction", 2009;
// Kuzmin et al., "Failsafe flux limiting and constrained data projections", 2010.
std::vector<double> bounded_projection(const mesh& m, const mesh_links& links,
                                       const mass_matrix& mass, const std::vector<local_load>& load,
                                       const std::vector<double>& b, const std::vector<double>& x);

}  // namespace asterism::internal
