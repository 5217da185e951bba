// SPDX-License-Identifier: MIT
//
// Collapses and splits around triangles of much energy. Each change is tried, its surroundings are
// relaxed, and it is kept only if the energy has fallen.
#pragma once

#include <cstddef>

#include "asterism/mesh/optimize/smooth_and_swap.hpp"

namespace asterism::internal::fitting {

struct surgery_report {
  std::size_t tried = 0, collapsed = 0, split = 0;
};

// Goes once over the triangles there are, the worst first, with six attempts at most for each. Ends
// early when the mover is cancelled.
surgery_report operate(mutable_mesh& m, mover& moves);

}  // namespace asterism::internal::fitting
