// SPDX-License-Identifier: MIT
//
// Makes a mesh on which all stars agree where the metric as given allows none.
//
// Stars see each other differently at any distance that sites can have where a metric jumps, or
// turns by much over one edge (docs/math/refinement.md). A site's metric is its own, however: the
// metric is made to vary more slowly, step by step, and meshed again, until no triangle disagrees.
//  1. Softened, unless it jumps: as many sites everywhere, the aspect of triangles to the power of
//     0.7, then 0.5.
//  2. Graded (metric/graded_field.hpp) with 1.5, then 1.2, over the length wanted of an edge;
//     without a size over a sixteenth of the domain; over more where the limit on sites makes edges
//     longer.
//  3. Everywhere the same: the log-Euclidean mean of the tensors at the sites there are.
//  4. The same without demands on angles and sizes. Equal metrics make the stars those of one
//     Delaunay triangulation where no subsegment is encroached.
// Eight meshes at most are made, each of which ends by the bounds of refinement.
//
// The tensors delivered and given are both reported, the mesh is certified in the former, and its
// angles are judged in the latter as well. It does not hold that the steps are the least that would
// do, or that 4 ends with agreement where the limit on sites leaves no room to split what is
// encroached; then the outcome is the one in the metric given.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/data/outcome.hpp"
#include "asterism/mesh/refine/meshing_context.hpp"

namespace asterism::internal {

// True if `made`, in the metric given, is to be replaced: some of its triangles disagree, or it has
// no sites but the given ones because no others could be spread.
bool wants_relaxation(const mesh_outcome& made, const mesh_options& options);

// Makes everything of the outcome but the counters, which the kernel has. Requires
// wants_relaxation(as_given, job.options). The job's domain and field, and `as_given`, are in the
// caller's units. Fails where the field fails at a site of the mesh.
result<mesh_outcome> refine_relaxed(const meshing_context& job, mesh_outcome as_given);

}  // namespace asterism::internal
