// SPDX-License-Identifier: MIT
//
// Computes with thin metrics: tensors whose quadratic form cancels in doubles because its ellipse
// is long and oblique, and the coordinates in which such a metric is round.
//
// m11 dx^2 + 2 m12 dx dy + m22 dy^2 loses a factor m11 m22 / det of precision in the long direction
// of the ellipse: all of it at an aspect of 1e8. The tensor is exactly the one whose entries the
// doubles are, and its form is evaluated here with small relative error.
#pragma once

#include "asterism/core/site.hpp"

namespace asterism::internal {

// True if more than 14 bits can be lost to cancellation: an aspect above about 250, at 45 degrees.
inline bool is_thin(const metric_tensor& m) {
  return !(m.m12 * m.m12 <= (1 - 0x1p-14) * (m.m11 * m.m22));
}

// Returns m11 - m12^2 / m22, the least value of the form at displacements with dx = 1: m22 times it
// is the determinant, without the square of the entries' range. Requires a positive definite
// tensor; good to a few units in the last place whatever its condition number.
double least_across(double m11, double m12, double m22);
// Returns the square root of the determinant, with the same precision and range.
double root_of_determinant(const metric_tensor& m);

// Returns u^T M u for u = (dx, dy), good to a few units in the last place of the exact value for
// these doubles.
double squared_length_of_thin(const metric_tensor& m, double dx, double dy);

// Coordinates around an origin in which one metric, thin or not, is about the identity, and others
// like it are about round: x' = F (x - origin) with F^T F = M up to rounding. F is upper triangular
// with a positive diagonal, so orientations stay.
//
// Positions are mapped with an error of about aspect 2^-52 as the metric measures it; tensors as if
// exactly and rounded once, so that equal ones stay equal.
class round_coordinates {
 public:
  round_coordinates(const point& origin, const metric_tensor& round);

  site inward(const site& s) const;
  // Maps a displacement from the origin.
  point outward(const point& u) const;

 private:
  metric_tensor inward(const metric_tensor& m) const;

  point origin_;
  double f11_, f12_, f22_;  // F
  double g11_, g12_, g22_;  // its inverse
};

}  // namespace asterism::internal
