// SPDX-License-Identifier: MIT
//
// Bounds square roots of rationals, and rounds rationals upwards; inside the auditor alone.
#pragma once

#include "asterism/mesh/audit/number.hpp"

namespace asterism::internal::audit_detail {

// Return a lower or upper bound of sqrt(square) with an error below 2^-199 of it. Require square >=
// 0.
rational root_above(const rational& square);
rational root_below(const rational& square);
// Returns the least double that is not below the number; infinity where that overflows.
double double_above(const rational& number);
// Returns an upper bound of sqrt(square), as a double; infinity where that overflows.
double root_rounded_up(const rational& square);
// Returns the distance from a double of this size to the next one.
double unit_in_last_place(double size);

}  // namespace asterism::internal::audit_detail
