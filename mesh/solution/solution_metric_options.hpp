// SPDX-License-Identifier: MIT
//
// Holds the options of the metric that is made for a solution.
#pragma once

#include <limits>
#include <optional>

#include "asterism/mesh/solution/hessian.hpp"

namespace asterism {

// Default growth of sizes, with which adaptation loops do best (docs/results/adaptation.md compares
// growths of 1.5 to 12, and unlimited growth). Meshes never have a faster growth, as stars do not
// agree in such a metric; with a growth below 3, gradation uses up vertices that fronts need.
inline constexpr double loop_gradation = 6;

// Aspect if none is named: then the aspect along layers of a solution that was computed in linear
// elements is bounded by what the layers are like (docs/manual/adaptation.md).
inline constexpr double no_aspect_named = 1e6;

// Options of the metric. At most one of vertices, complexity and error; without any, the number of
// vertices is that of the mesh.
struct solution_metric_options {
  hessian_method hessian = hessian_method::green;
  std::optional<double> norm = 2;       // p of L^p, at least 1; none: the maximum norm
  std::optional<double> vertices = {};  // a mesh of unit edges has 2 / sqrt 3 times the complexity
  std::optional<double> complexity = {};  // area in the metric
  std::optional<double> error = {};  // of linear interpolation in the norm, greatest of the fields
  double least_size = 0;
  double greatest_size = std::numeric_limits<double>::infinity();
  // Length over width of triangles; the default leaves the bound to fields that were computed.
  double aspect = no_aspect_named;
  std::optional<double> gradation = {};  // beta above 1; none: sizes stay as they are
  bool gradation_keeps_shape = false;    // in metric space; else in mixed space
  bool isotropic = false;
  std::optional<double> step = {};  // greatest factor by which a length changes, above 1
  // True for an error relative to the field's greatest less its least value, or, with a cutoff C,
  // to the modulus of the value at each vertex, or C times the greatest modulus where that is more.
  // The norm is not used.
  bool relative = false;
  std::optional<double> cutoff = {};  // above 0, at most 1
};

}  // namespace asterism
