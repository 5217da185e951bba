// SPDX-License-Identifier: MIT
//
// Chooses the power of two that brings n = J M d to the size of d (predicates/visible_arc.hpp):
// about 1 / sqrt(det M), read off the exponents of the diagonal. Any power gives the same answers;
// this one keeps arc parameters near one.
#pragma once

#include <cmath>

#include "asterism/core/site.hpp"

namespace asterism::internal {

inline int turn_scale_exponent(const metric_tensor& m) {
  return -(std::ilogb(m.m11) + std::ilogb(m.m22)) / 2;
}

}  // namespace asterism::internal
