// SPDX-License-Identifier: MIT
//
// Encloses a function of the plane and its derivatives over a box: interval arithmetic by the rules
// of differentiation. All functions require a floating_point_scope(rounding::upward).
//
// For a function with kinks (absolute values, the lesser of two) the derivatives are those on each
// side, and all between: along any segment the function's derivative is in x du + y dv wherever it
// has one, which is almost everywhere. Where a function may jump they are infinite.
#pragma once

#include "asterism/core/rounded_interval.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

struct interval_jet {
  rounded_interval value, x = 0, y = 0;  // x, y: the derivatives by these

  interval_jet() = default;
  interval_jet(double constant) : value(constant) {}
  interval_jet(const rounded_interval& v, const rounded_interval& by_x,
               const rounded_interval& by_y)
      : value(v), x(by_x), y(by_y) {}
};

interval_jet operator+(const interval_jet& a, const interval_jet& b);
interval_jet operator-(const interval_jet& a, const interval_jet& b);
interval_jet operator-(const interval_jet& a);
interval_jet operator*(const interval_jet& a, const interval_jet& b);
interval_jet operator/(const interval_jet& a, const interval_jet& b);

// Enclose the functions by the names that formulas use for doubles as well.
interval_jet square(const interval_jet& a);
interval_jet square_root(const interval_jet& a);
interval_jet exponential(const interval_jet& a);
interval_jet natural_logarithm(const interval_jet& a);
interval_jet sine(const interval_jet& a);
interval_jet cosine(const interval_jet& a);
interval_jet hyperbolic_tangent(const interval_jet& a);
interval_jet arc_tangent(const interval_jet& a);
interval_jet absolute(const interval_jet& a);
interval_jet lesser(const interval_jet& a, const interval_jet& b);
interval_jet greater(const interval_jet& a, const interval_jet& b);
// Returns a^n for a whole number n with |n| <= 64.
interval_jet whole_power(const interval_jet& a, int n);
// Returns an enclosure of two functions, either of which may be the value: derivatives are
// infinite, unless both are the same constant.
interval_jet either(const interval_jet& a, const interval_jet& b);

// Encloses the tensors of a field over a box, with their derivatives.
struct tensor_jet {
  interval_jet m11, m12, m22;
};

// Encloses the coordinates of the points of a box.
struct plane_jet {
  interval_jet x, y;
};
plane_jet coordinates_over(const rounded_interval& x, const rounded_interval& y);

}  // namespace asterism::internal
