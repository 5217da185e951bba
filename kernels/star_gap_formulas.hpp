// SPDX-License-Identifier: MIT
//
// Defines the formulas of star_gap over any number type, so that a test can run them on one that
// counts roundings and magnitudes, and the bounds of their errors.
//
// A bound is depth * rho * magnitude (kernels/normal_frame.hpp): `depth` factors 1 + theta, |theta|
// <= rho, on any monomial, plus one for the magnitude's own rounding and the second order;
// `magnitude` is the formula with every component of a displacement replaced by its 1-norm, every
// entry of a tensor by its trace, and every sign by plus. Derivation:
// docs/math/star-gap-errors.md, section 2.
#pragma once

#include "asterism/core/plane_algebra.hpp"

namespace asterism::internal::star_gap_detail {

// Coefficients of the ray equation: on the ray p = v + u/s from v, s > 0, C s^2 - 2 H s - A has the
// sign of f_z - f_v at p; the larger root is the first meeting with the bisector of v and z = v +
// d.
template <class Number>
struct ray_equation {
  Number c, h, a;

  // Tensor N_z in v's frame; `dual` is N_z d. |u|_v^2 is an argument since it serves many z.
  ray_equation(const basic_metric_tensor<Number>& n, const displacement<Number>& d,
               const displacement<Number>& dual, const displacement<Number>& u,
               const Number& u_squared)
      : c(dot(d, dual)), h(dot(u, dual)), a(u_squared - dot(u, apply(n, u))) {}

  Number at(const Number& s) const { return (c * s - (h + h)) * s - a; }
  // Returns the discriminant of the ray equation, over 4.
  Number discriminant() const { return h * h + a * c; }
};

// Returns C - det N |d|^2: positive where s_z is convex in u, negative where it is concave.
template <class Number>
Number convexity(const Number& c, const Number& determinant, const displacement<Number>& d) {
  return c - determinant * dot(d, d);
}

// Returns |p-w|_w^2 + |x-w|_x^2 - |p-w|_x^2, times s^2; p = v + u/s is on the bisector, w = v + d.
template <class Number>
Number steepness_towards(const Number& s, const displacement<Number>& d, const Number& c_x,
                         const Number& a_x, const displacement<Number>& dual_x,
                         const displacement<Number>& u_seen_by_x) {
  const Number along = dot(d, dual_x), across = dot(d, u_seen_by_x);
  return ((c_x - (along + along)) * s + (across + across)) * s + a_x;
}

// Returns the discriminant of the ray equation in the direction z, where turn = d x z. Its root
// plus a function linear in z is C S.
template <class Number>
Number radicand_on_ray(const Number& c, const Number& determinant, const displacement<Number>& z,
                       const Number& turn) {
  return c * dot(z, z) - determinant * (turn * turn);
}

// Returns |e|^2 - bend (e x z)^2 for e = z + step n, n = +-J d with n . z = turn.
template <class Number>
Number radicand_beyond(const displacement<Number>& z, const displacement<Number>& d,
                       const Number& turn, const Number& bend, const Number& step) {
  const Number along = dot(d, z);
  return dot(z, z) + step * ((turn + turn) + step * (dot(d, d) - bend * (along * along)));
}

inline constexpr int ray_depth = 12, c_depth = 8, discriminant_depth = 16, convexity_depth = 9,
                     steepness_depth = 14, cross_depth = 5;
// Largest number of factors 1 + theta on any monomial of a side condition, without those of its
// quotients and roots.
inline constexpr int side_condition_depth = 24;

// Bounds magnitudes on the ray. `s` is at least the parameter; all arguments are positive.
inline double ray_magnitude(double s, double extent, double trace, double u) {
  return 4 * (trace * extent) * (s * (extent * s + u)) + (u * u) * (1 + trace);
}
inline double c_magnitude(double extent, double trace) { return 4 * trace * (extent * extent); }
inline double discriminant_magnitude(double extent, double trace, double u) {
  const double reach = extent * u;
  return 4 * trace * (reach * reach) * (1 + 2 * trace);
}
inline double convexity_magnitude(double extent, double trace) {
  return (trace * (extent * extent)) * (4 + 2 * trace);
}
inline double steepness_magnitude(double s, double extent, double extent_x, double trace_x,
                                  double u) {
  return 4 * s * trace_x * (s * extent_x * (extent_x + 2 * extent) + extent * u) +
         (u * u) * (1 + trace_x);
}
inline double radicand_on_ray_magnitude(double extent, double trace, double extent_z) {
  const double reach = extent * extent_z;
  return (reach * reach) * (8 * trace + 4 * (trace * trace));
}
inline double radicand_beyond_magnitude(double extent_z, double extent, double bend, double step) {
  const double reach = extent * extent_z;
  return 2 * (extent_z * extent_z) +
         step * (4 * reach + step * (2 * (extent * extent) + 4 * bend * (reach * reach)));
}

}  // namespace asterism::internal::star_gap_detail
