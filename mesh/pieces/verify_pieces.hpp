// SPDX-License-Identifier: MIT
//
// Decides whether the meshes of pieces are together a mesh of the domain (docs/math/pieces.md).
//
// It proves, in addition to the audit of each piece against its own domain,
//  - of the index: its edges are the segments of the domain, divided at further points up to
//    rounding, which enclose the region on their left exactly once, and cuts with a piece on each
//    side; so the boundaries of the pieces, as chains of directed edges, add up to that of the
//    domain; regions and markers are kept, and a cut has one region on both sides;
//  - of each piece: its own domain has the edges that the index gives to it, directed so, and no
//    others; and its mesh divides each seam at the points of the index, with the same tensors.
// Shares no code with the functions that cut domains and divide seams, except for the parts of
// curves.
#pragma once

#include <string>
#include <vector>

#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/pieces/pieces_index.hpp"

namespace asterism::internal {

// Returns the contradictions of the index by itself, a sentence each.
std::vector<std::string> faults_of_index(const pieces_index& index);

// Returns the contradictions of a piece's mesh and certificate with the whole, a sentence each. The
// mesh must be certified against the domain of its certificate.
std::vector<std::string> faults_of_piece(const pieces_index& index, piece_index piece,
                                         const mesh& subject, const certificate& claim);

// Returns the digests of the seams of a piece, by edge of the cut, as its mesh has them: over the
// positions and tensors of the vertices along each, ends included; 0 elsewhere, and where there is
// no chain from end to end.
seam_digests digests_of(const pieces_index& index, piece_index piece, const mesh& subject);

}  // namespace asterism::internal
