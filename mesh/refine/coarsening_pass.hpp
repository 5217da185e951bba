// SPDX-License-Identifier: MIT
//
// Improves a mesh that is complete already, if that is asked for: fewer sites, better shapes, and
// never a step that makes it worse.
//
// A pass proposes (refine/coarsening_proposal.hpp) and has the proposal refined as if it had come
// from the fill, all stars made anew. The result replaces the mesh only if it is complete as well,
// has no more sites or exempt triangles, no smaller worst angle and no lower mean quality, and
// either fewer sites or a higher mean quality. Otherwise the sites around the places that spoil it
// are left as they were, and the pass tries again, a bounded number of times.
#pragma once

#include <functional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

// Refines the proposal with at most `most` sites.
using refine_again =
    std::function<result<mesh_outcome>(const filled_domain& proposed, std::size_t most)>;

// Makes passes until one is not accepted, options.improve_passes at most, and reports them in
// `outcome.improved`. Leaves alone an outcome that is not complete. Keeps the last accepted one
// once options.stop asks for an end.
void improve(const meshing_context& job, const refine_again& refine, mesh_outcome& outcome);

}  // namespace asterism::internal
