// SPDX-License-Identifier: MIT
//
// A projection without new extrema.
#pragma once

#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"
#include "asterism/mesh/transfer/mass_matrix.hpp"

namespace asterism::internal {

// Brings the projection x of b as near as goes to itself without leaving, at any vertex, the values
// that the old field has in the triangles around it. The lumped projection b / (row sum) is a mean
// of such values, and both have one integral; they differ by fluxes along edges, m_ij (x_i - x_j),
// of which each gets the greatest part that keeps both its ends inside (Zalesak's limiter). What
// flows out of one end flows into the other, so that the integral stays. Source: Farrell et al.,
// "Conservative interpolation between unstructured meshes via supermesh construction", 2009; Kuzmin
// et al., "Failsafe flux limiting and constrained data projections", 2010.
std::vector<double> bounded_projection(const mesh& m, const mesh_links& links,
                                       const mass_matrix& mass, const std::vector<local_load>& load,
                                       const std::vector<double>& b, const std::vector<double>& x);

}  // namespace asterism::internal
