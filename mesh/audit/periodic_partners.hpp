// SPDX-License-Identifier: MIT
//
// Lists the vertices of two sides that go together.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns each vertex of the first side, from its start, with its partner. Fails as match_periodic
// does where the sides have no ends or another number of vertices; whether they are at the same
// places is for that to say.
result<std::vector<std::array<vertex_index, 2>>> periodic_partners(const mesh& subject,
                                                                   const periodic_pair& sides);

}  // namespace asterism::internal
