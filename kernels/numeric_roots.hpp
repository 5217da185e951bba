// SPDX-License-Identifier: MIT
//
// Finds real roots of polynomials of degree at most four in plain doubles: with them the double
// kernel cuts its sections, and the interval kernel chooses witnesses. Without a guarantee: roots
// of even multiplicity may be missed, close ones merged.
#pragma once

#include <array>
#include <cstddef>

#include "asterism/core/polynomial.hpp"

namespace asterism::internal::numeric {

// A fixed-capacity list in increasing order.
struct root_list {
  std::array<double, 4> value{};
  std::size_t count = 0;

  std::size_t size() const { return count; }
  double* begin() { return value.data(); }
  double* end() { return value.data() + count; }
};

root_list real_roots(const std::array<double, 5>& coefficients);

template <std::size_t Degree>
root_list real_roots(const polynomial<double, Degree>& p) {
  static_assert(Degree <= 4);
  std::array<double, 5> c{};
  for (std::size_t k = 0; k <= Degree; ++k) c[k] = p.coefficient[k];
  return real_roots(c);
}

}  // namespace asterism::internal::numeric
