// SPDX-License-Identifier: MIT
//
// Writes proofs in the format of docs/math/proof-format.md.
#pragma once

#include <functional>
#include <string_view>

#include "asterism/mesh/proof/mesh_proof.hpp"

namespace asterism::internal {

// Passes the bytes of a proof of the mesh to `put`, block by block.
void write_proof(const mesh& subject, const mesh_proof& proof,
                 const std::function<void(std::string_view)>& put);

}  // namespace asterism::internal
