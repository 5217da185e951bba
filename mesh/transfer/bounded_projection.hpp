// SPDX-License-Identifier: MIT
//
// Computes a projection without new extrema.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/mass_matrix.hpp"

namespace asterism::internal {

// Returns values near x, the solution of M x = b with the mass matrix M = (m_ij), that stay, at
// every vertex, within the old field's values in the triangles around it. The lumped projection
// b / (row sum of M) is a mean of old values and has the integral of x. It differs from x by fluxes
// along edges, m_ij (x_i - x_j), each of which is limited to the greatest part that keeps both ends
// of the edge within bounds (Zalesak's limiter). A flux adds to one end what it takes from the
// other, so that the integral stays. Source: Farrell et al., "Conservative interpolation between
// unstructured meshes via supermesh construction", 2009; Kuzmin et al., "Failsafe flux limiting and
// constrained data projections", 2010.
std::vector<double> bounded_projection(const mesh& m, const mesh_links& links,
                                       const mass_matrix& mass, const std::vector<local_load>& load,
                                       const std::vector<double>& b, const std::vector<double>& x);

}  // namespace asterism::internal
