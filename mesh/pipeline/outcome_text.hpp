// SPDX-License-Identifier: MIT
//
// Returns texts of how a run ended. Outcomes are data; sentences about them are written only here.
// Vertices in them count from `first_number`: 1 as in a .mesh file, or 0 as in arrays.
#pragma once

#include <string>

#include "asterism/core/export.h"
#include "asterism/mesh/data/outcome.hpp"

namespace asterism {

// Returns half a sentence, without a full stop, on how one refinement ended and why:
// "stuck: 3 bad triangles are left, and no candidates on Voronoi arcs farther than ...".
ASTERISM_EXPORT std::string ending_text(const refinement_ending& ended, int first_number = 1);

// Returns the text for a whole run. For a mesh in one metric for all sites it adds why there is no
// other mesh, the distance of that metric from the given one, and the measures by the given one.
// Certificates hold this text as their reason. For programs there is mesh_outcome::how().
ASTERISM_EXPORT std::string ending_text(const mesh_outcome& outcome, int first_number = 1);

}  // namespace asterism
