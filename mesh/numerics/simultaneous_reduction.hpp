// SPDX-License-Identifier: MIT
//
// Reduces two tensors simultaneously: both are diagonal in one basis, in which the first is the
// identity. In doubles, for building metrics; decides nothing.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal {

// Reduction of B relative to A = F^T F: F = [f11 f12; 0 f22], the eigenvalues of A^-1 B, and the
// eigenvectors (c, s), (-s, c) of F^-T B F^-1.
struct simultaneous_reduction {
  double f11, f12, f22;
  double c, s, high, low;
};

// Requires A to be positive definite. B may be any symmetric matrix where `low` is not used.
simultaneous_reduction reduce(const metric_tensor& a, const metric_tensor& b);

// Returns F^T Q diag(high, low) Q^T F, the tensor with these eigenvalues in the common basis.
metric_tensor restore(const simultaneous_reduction& r, double high, double low);

// Returns the tensor that measures a length at least as long as both do, by the greater eigenvalue
// in either common direction: the largest ellipse inside both unit ellipses. For three tensors or
// more the result depends on their order. Source: Alauzet and Frey, "Estimateur d'erreur
// geometrique et metriques anisotropes", INRIA RR-4759, 2003.
metric_tensor simultaneous_intersection(const metric_tensor& a, const metric_tensor& b);

}  // namespace asterism::internal
