// SPDX-License-Identifier: MIT
//
// Computes what doubles propose with rounding to nearest, within a scope that rounds upward too.
// A proposal decides nothing, but how soon a search ends depends on it: made in one rounding mode
// everywhere, the same tier decides the same question on every target, also on those without
// directed rounding.
#pragma once

#include "asterism/core/floating_point_environment.hpp"

namespace asterism::internal {

// Out of line: the compiler must not move arithmetic across the change of the rounding mode.
template <class Propose>
[[gnu::noinline]] auto propose_out_of_line(const Propose& propose) {
  return propose();
}

// Returns propose().
template <class Propose>
auto proposal(const Propose& propose) {
  const floating_point_scope scope(rounding::nearest);
  return propose_out_of_line(propose);
}

}  // namespace asterism::internal
