// SPDX-License-Identifier: MIT
//
// Computes logarithms and intersections of metric tensors in plain doubles: for building metric
// fields, never for a decision about a mesh.
//
// Tensors must be finite and positive definite with a condition number below 1e14; results are
// accurate to about that condition number times 1e-16 in the weak direction, and positive definite.
// Scaled by powers of two inside, so entries may be of any size.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal {

// A symmetric matrix; eigenvalues may have either sign.
struct tensor_logarithm {
  double l11 = 0, l12 = 0, l22 = 0;
};

// Converts to the matrix logarithm and back. Means of logarithms are the "log-Euclidean" means of
// tensors: always positive definite, and geometric means where directions agree. Source: Arsigny,
// Fillard, Pennec, Ayache, "Log-Euclidean metrics for fast and simple calculus on diffusion
// tensors", 2006.
//
// An exponential has a condition number of 2^48 at most: a thinner one, as halfway between a metric
// of 1e240 and one of 1, is limited to a condition that doubles certainly keep positive definite.
tensor_logarithm logarithm(const metric_tensor& m);
metric_tensor exponential(const tensor_logarithm& l);
// Computes the exponential from eigenvalues with relative errors of 1e-13 (quick_logarithm.hpp), in
// a third of the time: for metrics that steer how a mesh is made.
metric_tensor quick_exponential(const tensor_logarithm& l);

// Adds a tensor's logarithm, times a weight, to a sum of logarithms.
inline void add_weighted(double weight, const tensor_logarithm& term, tensor_logarithm& sum) {
  sum = {sum.l11 + weight * term.l11, sum.l12 + weight * term.l12, sum.l22 + weight * term.l22};
}

// Returns the larger eigenvalue of |a - b|: twice the logarithm of the largest ratio of lengths, to
// first order.
double difference(const tensor_logarithm& a, const tensor_logarithm& b);

// True if the squared length of some direction in `b` exceeds that in `a` by more than the part
// `slack`.
bool exceeds(const metric_tensor& b, const metric_tensor& a, double slack);

// Returns a metric at least as long as both in every direction. It has the largest of their four
// eigenvalues with its eigenvector n, and across n its lengths are the shortest that this requires.
// The shortest length does not get shorter, so that passing metrics on from point to point ends.
// (The largest ellipse inside both unit ellipses, the usual intersection, has a smaller tensor, but
// between two thin ellipses turned against each other it is shorter than both in every direction,
// and repeated it shrinks without bound.)
metric_tensor intersection(const metric_tensor& a, const metric_tensor& b);

// Returns the tensor turned by the angle with this cosine and sine: R t R^T for the turn R. Exact
// for turns by quarters.
metric_tensor turned(const metric_tensor& t, double cosine, double sine);

// Returns sqrt(det b / det a), the ratio of the densities of sites: b's to a's.
double density_ratio(const metric_tensor& b, const metric_tensor& a);

// Returns two displacements of length 1 that are orthogonal in the metric: its unit circle is
// cos(t) first + sin(t) second.
struct unit_displacements {
  point first, second;
};
unit_displacements unit_circle(const metric_tensor& m);

}  // namespace asterism::internal
