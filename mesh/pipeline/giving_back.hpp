// SPDX-License-Identifier: MIT
//
// Gives the nodes of a mesh whose stars agree the tensors wanted, as many as the auditor lets pass.
// Internal to the pipeline.
#pragma once

#include <vector>

#include "asterism/mesh/adapt/agreement.hpp"
#include "asterism/mesh/adapt/working_mesh.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/audited_mesh.hpp"

namespace asterism::internal {

// Makes nodes more alike, in a mesh whose stars agree, whose gaps see so far that it is not known
// how far: an auditor holds all sites against these, and taking back does not end it. Where that is
// more than a few, the mesh stays as it is. `agreeing` is of this mesh.
void bound_gaps(adapting::working_mesh& m, adapting::agreement& agreeing, const cancellation& stop);

// Gives back; `wanted` has a tensor for each node. What is found against the mesh then is taken
// back (adapt/restoration.hpp), and where nothing is left to take back the mesh is mended. Of hard
// questions those are asked that nothing else answers: none about tensors that are taken back for
// another reason, the filters first, and exact numbers where nothing can be taken back. Returns
// whether the mesh that comes out, in `audited`, is certified.
bool give_back(adapting::working_mesh& m, std::vector<metric_tensor> wanted,
               const mesh_options& options, const adapting::agreement_options& mending,
               audited_mesh& audited);

}  // namespace asterism::internal
