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

// A domain found of a mesh, with chords for its cubics, and the former boundary along its segments.
struct chorded_outline {
  domain shape;
  former_boundary former;
};

// Halves the cubics of the outline while their chords are farther from them than a part of the size
// that the metric of the mesh wants across (mesh/domain/divide_curves.hpp). Without such a bound a
// chord as long as a wanted edge would stay at any distance from its cubic. Returns the outline as
// it is where it has no cubics, where they cannot be divided, or where there would be more chords
// than a quarter of the inside vertices of a mesh of unit edges. The latter occurs on coasts, where
// cubics are a guess.
chorded_outline with_chords_for(const mesh& m, const mesh_outline& found);

}  // namespace asterism::internal
