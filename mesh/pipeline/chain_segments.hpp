// SPDX-License-Identifier: MIT
//
// Finds the segment of the domain that each boundary edge of a mesh is a part of, for files without
// a place for that number.
#pragma once

#include "asterism/core/export.h"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Numbers the edges by their chains: from one vertex of the domain along others, which have two
// edges each, to the next one of the domain. The first vertices of the mesh are the domain's, in
// their order. Edges whose chain is no segment keep their number, which an audit then refuses.
ASTERISM_EXPORT void number_segments_by_chains(mesh& m, const domain& shape);

}  // namespace asterism::internal
