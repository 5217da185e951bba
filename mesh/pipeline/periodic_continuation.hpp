// SPDX-License-Identifier: MIT
//
// Continues a mesh across periodic sides, so that second derivatives of a periodic solution are
// recovered at these sides as in the interior.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/solution/glued_mesh.hpp"

namespace asterism::internal {

// Copies, beyond each side, the triangles near its partner, shifted or turned. Of several pairs the
// later ones copy the copies, too, so that the corners of a torus are inside. Returns nothing where
// no pair matches: sides that do not match yet stay boundary, and turned sides that meet do.
std::optional<glued_mesh> continued_across(const mesh& m, const std::vector<periodic_pair>& pairs);

}  // namespace asterism::internal
