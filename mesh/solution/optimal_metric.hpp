// SPDX-License-Identifier: MIT
//
// Computes metrics in which a linear interpolant of a field has the least error in an L^p norm.
//
// M = D det(|H|)^(-1/(2p+2)) |H|, with |H| the Hessian with the moduli of its eigenvalues, and D
// such that the complexity, the integral of the root of det M, is as wanted. For p = infinity the
// exponent is 0. Source: Loseille and Alauzet, "Continuous mesh framework", SIAM J. Numer. Anal. 49
// (1), 2011.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Share of the complexity that covers the whole domain at the least density allowed. A place
// without second derivatives determines no size and no direction, and gets the size of that
// density, twenty times that of a uniform mesh with the same number of vertices. Chosen by
// experiment (docs/results/adaptation.md).
inline constexpr double usual_floor_share = 0.0025;

// Lower bounds of a metric of complexity 1.
struct optimum_bounds {
  double floor_share;  // the least density over that of a uniform metric; above 0, below 1
  double eigenvalue;   // of an edge as long as the domain, which none is to exceed; above 0
  // Sides of the box around the domain, as parts of the longer one: along the shorter one edges are
  // no longer than that.
  std::array<double, 2> sides{1, 1};
};

struct optimal_metric {
  std::vector<metric_tensor> tensors;  // of complexity 1
  std::size_t floored = 0;             // vertices with an eigenvalue at a bound
  double flat_part = 0;  // of the complexity, of places of the least density: at most the share
  double ridge_part =
      0;  // of the complexity, of places denser whose edges are as long as the domain
  bool is_flat = false;  // no second derivatives anywhere: the tensors are all alike
};

// Returns the optimal metric. `norm` is p >= 1; none stands for infinity. No density (the root of
// the determinant) is below `floor_share` over the area of the domain, so that all places without
// second derivatives take at most that share of the complexity. At denser places no eigenvalue is
// below that of the longest edge along its eigenvector in the box, unless both are. Elsewhere the
// metric is the optimum under these bounds. At a place with the least density the weaker eigenvalue
// is the lowest with that density: from strong to flat places shapes change continuously. `round`
// gives both moduli the greater one's value.
optimal_metric make_optimal_metric(const std::vector<metric_tensor>& hessian,
                                   const std::vector<double>& areas, std::optional<double> norm,
                                   bool round, const optimum_bounds& bounds);

// Returns the integral of the root of the determinant.
double complexity_of(const std::vector<metric_tensor>& tensors, const std::vector<double>& areas);

// Returns the L^p norm of the error of linear interpolation of a field with this Hessian on a mesh
// of unit edges in `tensors`, by the continuous mesh model, with triangles that are equilateral in
// the metric. With a and b the second derivatives along their axes,
//   for p = 2 its mean square is ((a+b)/2)^2 / 60 + ((a-b)/2)^2 / 480. With d_i the second
//     derivatives along the three sides the error is -(1/2) sum d_i l_j l_k in barycentric
//     coordinates, and its mean square (sum d_i^2 + (sum d_i)^2) / 720;
//   for other p it is k (|a| + |b|) / 2, where k belongs to a = b: 1/8 for p = 1, 1/6 for infinity,
//     else by quadrature. Where a and b have different signs the result is too large, by a factor
//     of up to three.
double predicted_error(const std::vector<metric_tensor>& tensors,
                       const std::vector<metric_tensor>& hessian, const std::vector<double>& areas,
                       std::optional<double> norm);

}  // namespace asterism::internal
