// SPDX-License-Identifier: MIT
//
// Computes derivatives of piecewise linear fields: of triangles, averaged at vertices, and in the
// weak form.
#pragma once

#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Returns the gradient on each triangle; zero on one that is flat.
std::vector<point> triangle_gradients(const mesh& m, const std::vector<double>& values);

// Returns, at each vertex, the mean of the gradients of its triangles, weighted by their areas.
std::vector<point> mean_gradients(const mesh& m, const mesh_links& links,
                                  const std::vector<point>& of_triangles);

// Returns the second derivatives by averaging the gradients of the components of `gradients`.
std::vector<metric_tensor> second_means(const mesh& m, const mesh_links& links,
                                        const std::vector<point>& gradients);

// Returns the second derivatives in the weak form. Meaningless at the boundary.
std::vector<metric_tensor> weak_second_derivatives(const mesh& m, const mesh_links& links,
                                                   const std::vector<point>& of_triangles);

}  // namespace asterism::internal
