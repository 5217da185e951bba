// SPDX-License-Identifier: MIT
//
// Runs the refinement loop: looks for bad triangles, repairs stars and inserts sites, until nothing
// is bad or nothing helps.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

// Refines the job's domain with the proposed sites inserted first, and fills in the whole outcome
// without the counters, in the unit frame. Fails where the field does. With a kernel that is not
// exact the outcome claims what that kernel believes.
result<mesh_outcome> refine(const meshing_context& job, filled_domain proposed);

}  // namespace asterism::internal
