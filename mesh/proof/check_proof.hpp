// SPDX-License-Identifier: MIT
//
// Checks the proof of a mesh, as tools/check_mesh.py does, in exact arithmetic behind doubles with
// error bounds. Shares nothing with the auditor; with the search for witnesses it shares the
// conditions that are stated in mesh/proof/star_conditions.hpp.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal {

// Returns the first reason why the proof does not show that the mesh is as asked
// (docs/math/proof-format.md); nothing if it does.
std::optional<error> check_proof(const proof_question& asked, const mesh_proof& proof);

}  // namespace asterism::internal
