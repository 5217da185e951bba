// SPDX-License-Identifier: MIT
//
// Reads proofs in the format of docs/math/proof-format.md.
#pragma once

#include <string_view>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"

namespace asterism::internal {

// Returns the proof in these bytes, with its exceptions sorted. Fails if they are no proof, or one
// of a mesh with other numbers of vertices or triangles.
result<mesh_proof> read_proof(std::string_view bytes, const mesh& subject);

}  // namespace asterism::internal
