// SPDX-License-Identifier: MIT
//
// Fits quadratics to the values around vertices, by least squares.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

struct fitted_quadratic {
  point gradient;
  metric_tensor second;
};

// Returns the covariance of the displacements from v to its neighbours.
metric_tensor neighbour_covariance(const mesh& m, const mesh_links& links, vertex_index v);

// Returns the quadratic through the value at v that fits two rings of neighbours best, each error
// divided by the square of the distance; three or four rings where two do not determine one, and
// none where those do not either.
std::optional<fitted_quadratic> fit_quadratic(const mesh& m, const mesh_links& links,
                                              const std::vector<double>& values, vertex_index v);

}  // namespace asterism::internal
