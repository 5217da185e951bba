// SPDX-License-Identifier: MIT
//
// Finds the parts of a domain's curves in one of its pieces.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/domain_curve.hpp"
#include "asterism/mesh/pieces/domain_cut.hpp"

namespace asterism::internal {

// Returns the parts of the domain's curves along chords in a row that are the piece's, in the
// numbers of the cut's vertices. A chord with the end of a cut inside it, and one that is a seam,
// stay straight in both pieces. The control points of a part of a cubic are computed and rounded;
// arcs keep their centre.
std::vector<domain_curve> curves_of_piece(const domain& d, const domain_cut& cut,
                                          piece_index piece);

}  // namespace asterism::internal
