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

struct optimal_metric {
  std::vector<metric_tensor> tensors;   // of complexity 1
  std::vector<metric_tensor> absolute;  // the |H| they were made of, floored
  std::size_t floored = 0;              // vertices with an eigenvalue below the floor
  bool is_flat = false;                 // no second derivatives anywhere: the tensors are all alike
};

// `norm` is p >= 1; none stands for infinity. Eigenvalues below 1e-8 of the greatest of all are
// raised to that, as a flat place has no direction. `round` gives both eigenvalues the greater
// one's value.
optimal_metric make_optimal_metric(const std::vector<metric_tensor>& hessian,
                                   const std::vector<double>& areas, std::optional<double> norm,
                                   bool round);

// Returns the integral of the root of the determinant.
double complexity_of(const std::vector<metric_tensor>& tensors, const std::vector<double>& areas);

// Returns the L^p norm of the error of linear interpolation that a mesh of unit edges in `tensors`
// has, as the continuous mesh has it: at each place k tr(M^-1 |H|) / 2, where k belongs to an
// equilateral triangle of side 1 and a convex function: 1/8 for p = 1, 1 / (2 sqrt 15) for 2, 1/6
// for infinity, else by quadrature.
double predicted_error(const std::vector<metric_tensor>& tensors,
                       const std::vector<metric_tensor>& absolute, const std::vector<double>& areas,
                       std::optional<double> norm);

}  // namespace asterism::internal
