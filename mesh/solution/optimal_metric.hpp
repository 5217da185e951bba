// SPDX-License-Identifier: MIT
//
// Metrics in which a linear interpolant of a field has the least error in an L^p norm.
//
// M = D det(|H|)^(-1/(2p+2)) |H|, with |H| the Hessian with the moduli of its eigenvalues, and D
// such that the complexity, the integral of the root of det M, is as wanted. For p = infinity the
// exponent is 0. Source: Loseille and Alauzet, "Continuous mesh framework", SIAM J. Numer. Anal. 49
// (1), 2011.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Part of the complexity that it would take to cover the whole domain with the greatest size there
// may be. A place without second derivatives has no size of its own and no direction, and gets that
// size, twenty times that of a uniform mesh of as many vertices; where one eigenvalue is too
// small, so does its direction. By experiment (docs/results/adaptation.md).
inline constexpr double usual_floor_share = 0.0025;

struct optimal_metric {
  std::vector<metric_tensor> tensors;  // of complexity 1
  std::size_t floored = 0;             // vertices with an eigenvalue at the floor
  bool is_flat = false;                // no second derivatives anywhere: the tensors are all alike
};

// `norm` is p >= 1; none stands for infinity. No eigenvalue of the metric is below `floor_share`
// over the area of the domain: all places in which both are that take so much of the complexity at
// most, and what is left is the optimum under this bound. `round` gives both moduli the greater
// one's value.
optimal_metric make_optimal_metric(const std::vector<metric_tensor>& hessian,
                                   const std::vector<double>& areas, std::optional<double> norm,
                                   bool round, double floor_share);

// Returns the integral of the root of the determinant.
double complexity_of(const std::vector<metric_tensor>& tensors, const std::vector<double>& areas);

// Returns the L^p norm of the error of linear interpolation of a field with this Hessian that a
// mesh of unit edges in `tensors` has, as the continuous mesh has it, on triangles that the metric
// sees as equilateral. With a and b the second derivatives along their axes,
//   for p = 2 its mean square is ((a+b)/2)^2 / 60 + ((a-b)/2)^2 / 480. With d_i the second
//     derivatives along the three sides the error is -(1/2) sum d_i l_j l_k in barycentric
//     coordinates, and its mean square (sum d_i^2 + (sum d_i)^2) / 720;
//   for other p it is k (|a| + |b|) / 2, where k belongs to a = b: 1/8 for p = 1, 1/6 for infinity,
//     else by quadrature. Where a and b have two signs that is too much, up to three times.
double predicted_error(const std::vector<metric_tensor>& tensors,
                       const std::vector<metric_tensor>& hessian, const std::vector<double>& areas,
                       std::optional<double> norm);

}  // namespace asterism::internal
