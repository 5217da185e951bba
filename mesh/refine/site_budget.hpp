// SPDX-License-Identifier: MIT
//
// Fills the domain before refinement, within the limit on sites. Where the size wanted takes more,
// the domain is filled for longer edges, all by the same factor.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

struct budgeted_filling {
  filled_domain proposed;  // measured in the field divided by 2^halvings (refine/coarser_mesh.hpp)
  int halvings = 0;        // of the number of sites: edges are 2^(halvings / 2) times as long
  double work_units = 0;   // done in all attempts
};

// Fills the domain for strategies that begin with a fill; for others proposes nothing. Divides the
// metric by the smallest power of two for which the fill is predicted to use at most 80 % of
// `max_sites`. Fails as fill() does.
result<budgeted_filling> fill_within_budget(const meshing_context& job);

}  // namespace asterism::internal
