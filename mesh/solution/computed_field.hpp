// SPDX-License-Identifier: MIT
//
// Distinguishes values that a finite element method computed from values of a function, and bounds
// the aspect of triangles along the layers of computed ones.
//
// A solution in linear elements fulfils its equation vertex by vertex, and so its weak Laplacian
// there is made of the right-hand side and of first derivatives: it varies smoothly over the mesh.
// Its values, and a quadratic fitted to them, carry the errors of the method. For values of a
// function the reverse holds: quadratics fit them smoothly, and the weak form, which is not
// consistent on irregular meshes, varies from vertex to vertex. So the ratio of the two roughnesses
// distinguishes both kinds of fields, whatever the equation: 0.09 to 0.48 in solutions of advection
// and diffusion, of reaction and diffusion, and of Poisson's equation with layers of a hundredth
// and a thousandth, and 1.0 and more in fifteen functions on grids and in loops of 500 and 2,000
// vertices (docs/results/adaptation.md).
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Bounds of roughness::ratio(): a field counts as computed below the first, and as values of a
// function above the second.
inline constexpr double ratio_of_computed = 0.6, ratio_of_function = 0.95;
// Bounds of roughness::fitted: a field is resolved by the mesh below the first, and not resolved
// above the second, where both roughnesses come from the field's own higher derivatives. In loops
// solutions have 0.02 to 0.04; layers of a third of a grid's spacing have 0.9.
inline constexpr double roughness_of_resolved = 0.1, roughness_of_unresolved = 0.2;
// Least bound of the aspect, and the ratio of the bound to the steepness. By experiment: the best
// bounds are 7 to 14 for layers of three hundredths, 20 to 40 for layers of a hundredth (steepness
// 75), 150 to 400 for layers of a thousandth (steepness 713). Without a least bound smooth
// solutions, whose steepness is 2 to 4, would be isotropic.
inline constexpr double least_aspect_bound = 14, aspect_of_steepness = 0.27;

// Distance of second derivatives at a vertex from the linear function that fits its neighbours'
// best, as a part of the second derivatives there.
struct roughness {
  double weak = 0;    // of the Laplacian in the weak form
  double fitted = 0;  // of that of fitted quadratics
  // Returns weak / fitted. Adds a small number to both, so that the ratio is about 1 if both are
  // negligible beside a method's errors.
  double ratio() const {
    constexpr double nothing = 1.0 / 512;
    return (weak + nothing) / (fitted + nothing);
  }
};

// Returns medians over about a thousand vertices where second derivatives are strong. None where
// fewer than sixteen vertices can be judged.
std::optional<roughness> roughness_of(const mesh& m, const mesh_links& links,
                                      const std::vector<double>& values);

// Returns the ratio of the diagonal of the box around the mesh to the width of the field's layers:
// that diagonal times the mean slope, weighted by its square, over the range of the values. It does
// not depend on the mesh where this resolves the layers. 0 for a constant.
double steepness(const mesh& m, const std::vector<double>& values);

// Returns the bound on aspects that a field asks for; none for values of a function. Between the
// two ratios the logarithm of the bound grows to infinity, so that the bound is continuous in the
// ratio.
std::optional<double> aspect_bound(const mesh& m, const mesh_links& links,
                                   const std::vector<double>& values);

// Raises weaker eigenvalues of a metric, so that it stretches no triangle more than that.
void bound_aspects(double aspect, std::vector<metric_tensor>& tensors);

}  // namespace asterism::internal
