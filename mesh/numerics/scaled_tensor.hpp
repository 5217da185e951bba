// SPDX-License-Identifier: MIT
//
// Multiplies metric tensors by powers of two.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "asterism/core/site.hpp"

namespace asterism::internal {

inline metric_tensor times(const metric_tensor& m, double factor) {
  return {m.m11 * factor, m.m12 * factor, m.m22 * factor};
}

// Returns the tensor times 2^exponent: exact while no entry leaves the range of normal doubles.
// Multiplies by the power where that is a normal double, which gives the result of scalbn.
inline metric_tensor times_power_of_two(const metric_tensor& m, int exponent) {
  constexpr int bias = 1023, mantissa_bits = 52;
  if (-bias < exponent && exponent <= bias)
    return times(
        m, std::bit_cast<double>(static_cast<std::uint64_t>(exponent + bias) << mantissa_bits));
  return {std::scalbn(m.m11, exponent), std::scalbn(m.m12, exponent), std::scalbn(m.m22, exponent)};
}

}  // namespace asterism::internal
