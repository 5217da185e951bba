// SPDX-License-Identifier: MIT
//
// Finds the proof of a certified mesh.
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"

namespace asterism::internal {

// Returns the witnesses of a mesh that the auditor certified, and, if the domain is given, of its
// hole and region points. Fails if no witness of a kind that the format has is found; the message
// names the edge or gap. The mesh remains certified in that case.
result<mesh_proof> make_proof(const mesh& subject, const domain* shape = nullptr);

}  // namespace asterism::internal
