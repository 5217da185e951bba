// SPDX-License-Identifier: MIT
//
// Improves a mesh that is complete already, if that is asked for: fewer sites, better shapes, in
// the metric it has, and no step that makes it worse.
//
// A pass changes the triangles by local changes in doubles (mesh/adapt/unit_mesh.hpp), then refines
// the changed sites as if they had come from the fill, with all stars made anew. The result
// replaces the mesh only if it is complete as well, has no more sites or exempt triangles, no
// smaller worst angle and no lower mean quality, and either fewer sites or a higher mean quality.
// Otherwise the sites around the places that got worse are left as they were, and the pass tries
// again, a bounded number of times. Internal to the pipeline.
#pragma once

#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

// Makes passes until one is not accepted, options.improve_passes at most, and reports them in
// `outcome.improved`. Does not change an outcome that is not complete, or has given vertices alone.
// Keeps the last accepted mesh once options.stop asks for an end.
void improve(const meshing_context& job, mesh_outcome& outcome);

}  // namespace asterism::internal
