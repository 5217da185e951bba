// SPDX-License-Identifier: MIT
//
// The optional pass over a mesh that is complete already: fewer sites, better shapes, and never a
// step that makes it worse.
//
// A pass proposes (refine/coarsening_proposal.hpp) and has what is left refined as if it had come
// from the fill, all stars made anew. What comes of it replaces the mesh only if it is complete as
// well, with no more sites, no smaller worst angle, no lower mean quality, and one of these better.
// Where it is not, the sites around the places that spoil it are left as they were, and it is tried
// again, a bounded number of times.
#pragma once

#include <functional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/fill/fill.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

// Refines what is proposed, with at most so many sites.
using refine_again =
    std::function<result<mesh_outcome>(const filled_domain& proposed, std::size_t most)>;

// Does options.improve_passes passes or as many as are accepted, and reports them in
// `outcome.improved`. An outcome that is not complete is left alone; so is the last accepted one
// once options.stop asks for an end.
void improve(const meshing_context& job, const refine_again& refine, mesh_outcome& outcome);

}  // namespace asterism::internal
