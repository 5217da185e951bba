// SPDX-License-Identifier: MIT
//
// Guesses the neighbours of all sites at once, in doubles, where no fill has seen them.
//
// The sites are triangulated in one metric, and edges flipped as the mean of the metrics at the
// four sites around wants them. Where metrics vary little over an edge, stars are about those of
// that triangulation. Nothing relies on it: each guess is confirmed exactly or not used.
#pragma once

#include "asterism/mesh/data/neighbour_lists.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Returns the neighbours that the star of each site is likely to have, counter-clockwise from the
// nearest; nothing where there is no triangulation to read them from. Requires a neighbourhood.
neighbour_lists guess_neighbours(const site_oracle& oracle, const cancellation& cancelled);

}  // namespace asterism::internal
