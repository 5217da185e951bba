// SPDX-License-Identifier: MIT
//
// Divides the cubics of a domain that was found of a mesh, as the curves of an exact domain are
// divided for a metric.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/former_boundary.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/domain/mesh_outline.hpp"

namespace asterism::internal {

// A domain found, with chords for its cubics, and the boundary before along its segments.
struct chorded_outline {
  domain shape;
  former_boundary former;
};

// Halves the cubics of the outline while their chords are farther from them than a part of the size
// that the metric of the mesh wants across (mesh/domain/divide_curves.hpp); without, a chord that
// is as long as an edge wanted stays however far it is. Returns the outline as it is where it has
// no cubics, where they cannot be divided, or where that takes more than a quarter as many chords
// as unit edges take vertices inside, as on a coast, where cubics are a guess.
chorded_outline with_chords_for(const mesh& m, const mesh_outline& found);

}  // namespace asterism::internal
