// SPDX-License-Identifier: MIT
//
// The statement that a proof is checked for.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// The statement that a proof is checked for; no part of it is read from the proof. Every edge of
// the mesh's boundary list is a segment. The domain is as in its .poly file, before any repair;
// null if the region that the boundary encloses is the domain.
struct proof_question {
  const mesh& subject;
  const domain* shape = nullptr;
  double angle_bound = 0;  // degrees, from 0 to below 90
  // Greatest distance allowed between curves of the domain, undivided as in its file, and their
  // chords.
  double chord_tolerance = 0;
  std::vector<vertex_index> required = {};  // vertices that the mesh's file says must stay
};

}  // namespace asterism::internal
