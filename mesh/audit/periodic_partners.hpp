// SPDX-License-Identifier: MIT
//
// Lists the vertices of two sides of a boundary that go together, by their order alone.
#pragma once

#include <array>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Returns each vertex of the side with the first marker, from its start, with the one of the second
// side that goes with it, from its end. Fails where they are no lines with two ends or have another
// number of vertices. Where these are is not asked.
result<std::vector<std::array<vertex_index, 2>>> periodic_partners(const mesh& m, int first,
                                                                   int second);

}  // namespace asterism::internal
