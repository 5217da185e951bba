// SPDX-License-Identifier: MIT
//
// Question: does this tensor measure lengths, that is, is it positive definite?
// Computes: signs of m11 and of m11 m22 - m12^2; degree 2.
// Returns: true when both are positive; a semidefinite tensor is refused.
// Laws: 1. scaling by a positive factor keeps the answer; 2. exchanging m11 and m22 keeps it;
//   3. negating m12 keeps it.
// Requires: finite numbers.
// Source: predicates of the batch protocol, `is_spd`; Sylvester's criterion.
#pragma once

#include "asterism/core/plane_algebra.hpp"
#include "asterism/core/sign.hpp"

namespace asterism::internal {

template <class Number>
uncertain_bool is_positive_definite(const basic_metric_tensor<Number>& m) {
  return is_positive(sign_of(m.m11)) & is_positive(sign_of(m.m11 * m.m22 - square(m.m12)));
}

}  // namespace asterism::internal
