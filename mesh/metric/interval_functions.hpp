// SPDX-License-Identifier: MIT
//
// Encloses elementary functions of rounded intervals, and their quotients by any numbers. All
// functions require a floating_point_scope(rounding::upward). Where a function has no value, or no
// bound, on a part of the argument, the enclosure is infinite on that side.
//
// Values come from core/elementary, which is off by at most six units in the last place where it
// rounds to nearest: at most 6 * 2^-52 < 2^-49 of the result. Ends are moved outward by 2^-49 of
// themselves and, for results that are subnormal, by 2^-1070.
#pragma once

#include "asterism/core/rounded_interval.hpp"

namespace asterism::internal {

rounded_interval everything();  // all real numbers
bool is_bounded(const rounded_interval& a);

// Returns an enclosure of a / b: all numbers where b may be zero.
rounded_interval divided(const rounded_interval& a, const rounded_interval& b);
// Returns the roots of the part of a that is not negative; zero where there is none.
rounded_interval root_of(const rounded_interval& a);
rounded_interval exponential_of(const rounded_interval& a);
rounded_interval logarithm_of(const rounded_interval& a);
rounded_interval sine_of(const rounded_interval& a);
rounded_interval cosine_of(const rounded_interval& a);
rounded_interval hyperbolic_tangent_of(const rounded_interval& a);
rounded_interval arc_tangent_of(const rounded_interval& a);

// Enclosures of functions of q = r^2 >= 0 that are analytic in q: C = cosh r, S = sinh(r) / r, and
// S' = (C - S) / (2 q), the derivative of S. All are positive and increase with q.
struct even_functions {
  rounded_interval cosh, sinhc, slope;
};
// Requires q.inf() >= 0.
even_functions even_functions_of(const rounded_interval& q);

}  // namespace asterism::internal
