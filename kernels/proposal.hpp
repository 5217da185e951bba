// SPDX-License-Identifier: MIT
//
// Computes proposals in doubles with rounding to nearest, also within a scope that rounds upward. A
// proposal decides nothing, but the length of a search depends on it: made in one rounding mode
// everywhere, the same tier decides the same question on every target, also on those without
// directed rounding.
#pragma once

#include "asterism/core/floating_point_environment.hpp"

namespace asterism::internal {

// Evaluates out of line: the compiler must not move arithmetic across the change of the rounding
// mode.
template <class Propose>
[[gnu::noinline]] auto propose_out_of_line(const Propose& propose) {
  return propose();
}

// Returns propose(), evaluated with rounding to nearest.
template <class Propose>
auto proposal(const Propose& propose) {
  const floating_point_scope scope(rounding::nearest);
  return propose_out_of_line(propose);
}

}  // namespace asterism::internal
