// SPDX-License-Identifier: MIT
//
// Measures lengths of edges in a metric. In doubles, for reports.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "asterism/core/site.hpp"
#include "asterism/mesh/numerics/constructions.hpp"

namespace asterism::internal {

// Returns the squared length of d as the metric measures it, in plain doubles: of a thin metric,
// where products cancel, it may be 0.
inline double plain_square(const metric_tensor& m, const point& d) {
  return std::max(0.0, d.x * (m.m11 * d.x + 2 * m.m12 * d.y) + m.m22 * d.y * d.y);
}

// Returns the root of that. metric_distance() is accurate for thin metrics as well, and takes
// longer.
inline double plain_length(const metric_tensor& m, const point& d) {
  return std::sqrt(plain_square(m, d));
}

// Returns the root of the determinant in plain doubles, 0 where rounding makes it negative.
// root_of_determinant() of numerics/ill_conditioned_metric.hpp is accurate for thin tensors as
// well.
inline double plain_root_of_determinant(const metric_tensor& m) {
  return std::sqrt(std::max(0.0, std::fma(m.m11, m.m22, -m.m12 * m.m12)));
}

// Returns the logarithmic mean of both ends' lengths of an edge: its length in a metric that
// changes geometrically along it. `log` returns the natural logarithm.
template <class Logarithm>
double logarithmic_mean(double a, double b, const Logarithm& log) {
  // Uses the arithmetic mean for nearly equal lengths: with x = ratio - 1 it is too large by x^2 /
  // 12, below 1e-7 there.
  constexpr double alike = 1e-3;
  const double ratio = a / b;
  return std::abs(ratio - 1) > alike ? (a - b) / log(ratio) : (a + b) / 2;
}

// Returns the distance from the site to q, as the site measures.
inline double metric_distance(const site& from, const point& q) {
  return std::sqrt(squared_distance(from, q));
}

// Returns the mean of both ends' lengths of an edge.
inline double edge_length(const site& p, const site& q) {
  return (metric_distance(p, q.position) + metric_distance(q, p.position)) / 2;
}

// True if an edge of this length is a unit edge: from 1/sqrt 2 to sqrt 2, between which halving or
// doubling it would bring it no nearer to 1.
inline bool is_unit_length(double length) {
  return length >= 1 / std::numbers::sqrt2 && length <= std::numbers::sqrt2;
}

}  // namespace asterism::internal
