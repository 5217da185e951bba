// SPDX-License-Identifier: MIT
//
// Multiplies metric tensors by powers of two.
#pragma once

#include <cmath>

#include "asterism/core/site.hpp"

namespace asterism::internal {

inline metric_tensor times(const metric_tensor& m, double factor) {
  return {m.m11 * factor, m.m12 * factor, m.m22 * factor};
}

// Returns the tensor times 2^exponent: exact while no entry leaves the range of normal doubles.
inline metric_tensor times_power_of_two(const metric_tensor& m, int exponent) {
  return {std::scalbn(m.m11, exponent), std::scalbn(m.m12, exponent), std::scalbn(m.m22, exponent)};
}

}  // namespace asterism::internal
