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
// distinguishes both kinds of fields, whatever the equation: 0.1 to 1.1 in solutions of advection
// and diffusion, of reaction and diffusion, and of Poisson's equation with straight and curved
// layers, and more than 1.07 in twelve functions in nearly all passes of loops
// (docs/results/adaptation.md). It does not where both roughnesses are the field's own: where the
// mesh resolves the field badly, and on grids on which the weak form is consistent. On such grids
// the two agree at each vertex.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/search/mesh_links.hpp"

namespace asterism::internal {

// Bounds of layer_measures::ratio(): a field counts as computed below the first, and as values of a
// function above the second.
inline constexpr double ratio_of_computed = 1, ratio_of_function = 1.07;
// Bounds of layer_measures::fitted: a field is resolved by the mesh below the first, and not
// resolved above the second, where both roughnesses come from the field's own higher derivatives.
// In loops solutions have 0.02 to 0.1; layers of a third of a grid's spacing have 0.9.
inline constexpr double roughness_of_resolved = 0.1, roughness_of_unresolved = 0.2;
// Least bound of the aspect, and the ratio of the bound to the aspect that interpolation wants
// along the layers. By experiment: the best bounds are 7 to 14 for curved layers where
// interpolation wants 5 to 10, and 14 to 30 for straight ones that meet in a corner, where it wants
// 4 to 20 in the median. For layers that are the same along themselves, where it wants any aspect,
// none is best with advection or reaction, and 14 to 30 with diffusion alone: the steepness bounds
// these. Without a least bound smooth solutions would be isotropic.
inline constexpr double least_aspect_bound = 10, bound_of_wanted_aspect = 1.5;

// Bounds of layer_measures::apart(): both roughnesses are the field's own below the first, and
// those of a method or a form above the second. On grids functions have up to 0.12; in loops
// solutions have 0.33 and more.
inline constexpr double apart_on_grids = 0.15, apart_of_computed = 0.3;

// Measures of a field at about a thousand vertices where its second derivatives are strong. Both
// roughnesses are medians of distances, as parts of the second derivatives there: from the linear
// function that fits the neighbours' second derivatives best.
struct layer_measures {
  double weak = 0;         // roughness of the Laplacian in the weak form
  double fitted = 0;       // roughness of that of fitted quadratics
  double differences = 0;  // of the two distances, with their signs, in the median
  // Aspect that interpolation wants along the layers: the root of the second derivative in the
  // direction of the gradient, which is across a layer, over that along the layer, in the median.
  // Infinite if the latter is 0.
  double aspect = 1;
  // Roughness that is negligible beside a method's errors.
  static constexpr double nothing = 1.0 / 512;
  // Returns weak / fitted, which is about 1 if both are negligible.
  double ratio() const { return (weak + nothing) / (fitted + nothing); }
  // Returns the differences over the fits' roughness, which is about 0 if both are negligible.
  double apart() const { return differences / (fitted + nothing); }
};

// Returns 1 for a field that linear elements computed, 0 for values of a function, and a share for
// fields of which this is not known.
double share_of_computed(const layer_measures& field);

// Measures a field's layers. None where fewer than sixteen vertices can be judged.
std::optional<layer_measures> measures_of_layers(const mesh& m, const mesh_links& links,
                                                 const std::vector<double>& values);

// Returns the ratio of the diagonal of the box around the mesh to the width of the field's layers:
// that diagonal times the mean slope, weighted by its square, over the range of the values. It does
// not depend on the mesh where this resolves the layers. 0 for a constant.
double steepness(const mesh& m, const std::vector<double>& values);

// Returns the bound on aspects that a field asks for; none for values of a function. As the share
// of a computed field falls to 0, the logarithm of the bound grows to infinity, so that the bound
// is continuous in the measures.
std::optional<double> aspect_bound(const mesh& m, const mesh_links& links,
                                   const std::vector<double>& values);

// Raises weaker eigenvalues of a metric, so that it stretches no triangle more than that.
void bound_aspects(double aspect, std::vector<metric_tensor>& tensors);

}  // namespace asterism::internal
