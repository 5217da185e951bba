// SPDX-License-Identifier: MIT
//
// Averages the moduli of second derivatives over the triangles around each vertex.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Returns the power of moduli that is averaged for the L^p norm, p / (2p + 1), or 1/2 for the
// maximum norm. Across a layer the optimal metric has sizes in proportion to |H|^(-p/(2p+1)), so
// that this power of |H| is a number of vertices on a unit of length. With the mean of this power,
// the triangles around a vertex get the number of vertices that they want in total; with the mean
// of |H| itself, in which the greatest weighs most, they would get more.
double power_averaged(std::optional<double> norm);

// Returns, for each vertex, the mean of |H| over the triangles at it, by area, where |H| of a
// triangle is the mean of its corners', and has the moduli of H's eigenvalues. The error of a
// triangle depends on |H| all over it; H from one ring of triangles nearly vanishes on the line
// where a front is steepest, and is greatest one triangle beside it, so that without the mean the
// triangles between would stay too large. Signs are removed before the mean: with them a wave's two
// halves would cancel. Vertices of the boundary keep their own |H|: a mean with the inside would
// weaken a layer at a wall, and a corner.
std::vector<metric_tensor> mean_moduli(const mesh& m, const mesh_links& links,
                                       const std::vector<metric_tensor>& hessian);

// Returns, for each vertex inside, the least tensor that is at least two others in their common
// directions: the vertex's own |H|, and the mean as above, but of |H|^power, taken to the power
// 1/power. Vertices of the boundary keep their own |H|. At a peak of |H|, as where a solution is
// singular, the mean alone would hide from the next mesh what this one begins to resolve, and
// refinement would stop. Requires a power above 0, finite. Chosen by experiment
// (docs/results/adaptation.md).
std::vector<metric_tensor> mean_moduli_with_peaks(const mesh& m, const mesh_links& links,
                                                  const std::vector<metric_tensor>& hessian,
                                                  double power);

}  // namespace asterism::internal
