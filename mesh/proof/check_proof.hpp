// SPDX-License-Identifier: MIT
//
// Checks the proof of a mesh, as tools/check_mesh.py does, in exact arithmetic behind doubles with
// error bounds. Shares nothing with the auditor; with the search for witnesses it shares the
// conditions that are stated in mesh/proof/star_conditions.hpp.
#pragma once

#include <optional>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/proof/mesh_proof.hpp"

namespace asterism::internal {

// What is asked: nothing of it is taken from the proof. Every edge of the mesh's boundary list is a
// segment. The domain is as its .poly file has it, before any repair; null: what the boundary
// encloses.
struct proof_question {
  const mesh& subject;
  const domain* shape = nullptr;
  double angle_bound = 0;  // degrees, from 0 to below 90
};

// Returns why the proof does not show that the mesh is what is asked (docs/math/proof-format.md);
// nothing if it does.
std::optional<error> check_proof(const proof_question& asked, const mesh_proof& proof);

}  // namespace asterism::internal
