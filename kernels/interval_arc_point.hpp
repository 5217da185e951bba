// SPDX-License-Identifier: MIT
//
// Encloses a point of a visible arc by intervals, for arc_search. Requires a
// floating_point_scope(rounding::upward).
#pragma once

#include "asterism/core/interval.hpp"
#include "asterism/predicates/visible_arc.hpp"

namespace asterism::internal {

// The point p at parameter m, by its weighted displacement from v.
struct interval_arc_point {
  displacement<interval> from_v;
  interval weight;

  interval_arc_point(const visible_arc<interval>& on, const interval& m)
      : from_v(on.c * on.direction(interval(1), m)),
        weight(on.h(m) + square_root_of_non_negative(on.e(m))) {}
};

}  // namespace asterism::internal
