// SPDX-License-Identifier: MIT
//
// The curves of a domain as one piece of it has them.
#pragma once

#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/domain_curve.hpp"
#include "asterism/mesh/pieces/domain_cut.hpp"

namespace asterism::internal {

// Returns the parts of the domain's curves along chords in a row that are the piece's, in the
// numbers of the cut's vertices. A chord that a cut ends on, inside it, and one that is a seam stay
// straight in both pieces. The control points of a part of a cubic are computed and rounded; arcs
// keep their centre.
std::vector<domain_curve> curves_of_piece(const domain& d, const domain_cut& cut,
                                          piece_index piece);

}  // namespace asterism::internal
