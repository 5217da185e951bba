// SPDX-License-Identifier: MIT
//
// Finds the proof of a certified mesh.
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"

namespace asterism::internal {

// Returns the witnesses of a mesh that the auditor certified, for the points at which the domain
// has holes and regions, if it is known. Fails where no witness of a kind that a proof can have is
// found: the message says of what; the mesh is none the worse for it.
result<mesh_proof> make_proof(const mesh& subject, const domain* shape = nullptr);

}  // namespace asterism::internal
