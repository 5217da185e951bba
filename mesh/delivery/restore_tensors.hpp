// SPDX-License-Identifier: MIT
//
// Restores the wanted tensors at the nodes of a mesh whose stars agree, as far as the auditor
// accepts them. Internal to the pipeline.
#pragma once

#include <vector>

#include "asterism/mesh/adapt/consistency_repair.hpp"
#include "asterism/mesh/adapt/editable_mesh.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/delivery/audited_mesh.hpp"

namespace asterism::internal {

// Reduces metric differences at gaps of unknown reach, in a mesh whose stars agree: an auditor
// would test every site against these gaps, and undoing restored tensors does not help. Changes
// nothing where there are more than a few. `agreeing` is of this mesh.
void bound_gaps(adapting::editable_mesh& m, adapting::consistency_repair& agreeing,
                const cancellation& stop);

// Restores tensors; `wanted` has one for each node. `agreeing` is of this mesh; `others_pass` tells
// that all edges and angles pass its tests before. Findings of the audit are undone
// (adapt/tensor_restoration.hpp), and where nothing is left to undo the mesh is repaired. Hard
// questions are decided last: not at all if their tensors are undone for another reason, by filters
// first, and by exact numbers once nothing can be undone. Returns whether the resulting mesh, in
// `audited`, is certified. Where it is not, undoes what was restored and begins `agreeing` anew,
// but leaves repairs.
bool give_back(adapting::editable_mesh& m, std::vector<metric_tensor> wanted,
               const mesh_options& options, adapting::consistency_repair& agreeing,
               bool others_pass, audited_mesh& audited);

}  // namespace asterism::internal
