// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/number_utils.h>

namespace asterism::oracle {

// Returns the number of distinct t in [0, 1] with c0 + c1 t + c2 t^2 = 0. Requires c0 != 0. From
// signs alone, so that it also serves numbers in which roots cannot be isolated.
template <class Number>
int roots_in_closed_unit_interval(const Number& c0, const Number& c1, const Number& c2) {
  const auto sign_of = [](const Number& n) { return static_cast<int>(CGAL::sign(n)); };
  const Number at_one = c0 + c1 + c2;
  const int start = sign_of(c0), end = sign_of(at_one), leading = sign_of(c2);
  if (start * end < 0) return 1;
  // One root is 1, the other c0 / c2. Tests 0 < c0 / c2 < 1.
  if (end == 0) return leading == start && sign_of(c2 - c0) == leading ? 2 : 1;
  // Both roots are inside, or none. Both are if the extremum is inside and the parabola opens
  // toward the sign of its ends.
  const bool extremum_inside =
      sign_of(c1) * leading < 0 && sign_of(c1 + Number(2) * c2) * leading > 0;
  if (leading != start || !extremum_inside) return 0;
  const int discriminant = sign_of(c1 * c1 - Number(4) * c0 * c2);
  return discriminant > 0 ? 2 : discriminant == 0 ? 1 : 0;
}

}  // namespace asterism::oracle
