// SPDX-License-Identifier: MIT
//
// Holds what a proof is to show.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Holds the question that a proof is checked for: no part of it is taken from the proof. Every edge
// of the mesh's boundary list is a segment. The domain is as its .poly file has it, before any
// repair; null: what the boundary encloses.
struct proof_question {
  const mesh& subject;
  const domain* shape = nullptr;
  double angle_bound = 0;  // degrees, from 0 to below 90
  // Bounds how far curves of the domain, undivided as its file has them, and their chords may be
  // from each other.
  double chord_tolerance = 0;
  std::vector<vertex_index> required = {};  // vertices that the mesh's file says must stay
};

}  // namespace asterism::internal
