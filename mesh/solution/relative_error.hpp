// SPDX-License-Identifier: MIT
//
// Computes metrics in which linear interpolation has an error relative to a field's values, as
// `err` of BAMG and of FreeFEM's adaptmesh.
//
// M = unit_share |H| / (E s), with |H| the Hessian with the moduli of its eigenvalues, E the
// relative error and s its reference: without a cutoff the greatest less the least value of the
// field (adaptmesh's default, `abserror` true and `rescaling` true), with a cutoff C at each vertex
// the modulus of the value there, or C times the greatest modulus where that is more (`abserror`
// false, `cutoff` C). So a displacement d of length 1 has about d^T |H| d = E s; the error of
// interpolation is at most 1/6 of that on triangles that are equilateral in M. No size is greater
// than the extent of the mesh. Source: the formulas of BAMG's Metric.cpp, FreeFEM 4.11.
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Factor between this metric and adaptmesh's for the same error: adaptmesh's meshes have fewer
// vertices than a mesh with unit edges in its metric. In twelve loops of adaptmesh (six fields,
// errors 0.01 and 0.001, ratio 1.8, 116 to 10220 vertices) the ratio of the numbers of vertices was
// 0.855 to 1.04, 0.947 in the mean. By experiment (docs/results/adaptation.md).
inline constexpr double unit_share = 0.94;

// Returns s at each vertex; nothing if all values are equal to 1e-10 of the greatest, so that no
// relative error is defined.
std::vector<double> scales_of_error(const std::vector<double>& values,
                                    std::optional<double> cutoff);

// Returns the metric from moduli of second derivatives; `round` gives both eigenvalues the greater
// modulus.
std::vector<metric_tensor> relative_metric(const std::vector<metric_tensor>& moduli,
                                           const std::vector<double>& scales, double error,
                                           double extent, bool round);

}  // namespace asterism::internal
