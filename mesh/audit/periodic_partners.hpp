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

// Pairs the vertices of the side with the first marker, from its start, with those of the second
// side, from its end. Fails where they are no lines with two ends, or have different numbers of
// vertices. Does not compare coordinates.
result<std::vector<std::array<vertex_index, 2>>> periodic_partners(const mesh& m, int first,
                                                                   int second);

}  // namespace asterism::internal
