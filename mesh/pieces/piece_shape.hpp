// SPDX-License-Identifier: MIT
//
// Defines the domain of one piece, with the divisions of its seams.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/fill/prescribed_divisions.hpp"
#include "asterism/mesh/pieces/domain_cut.hpp"

namespace asterism::internal {

// Points that divide each edge of a cut, in its direction, ends left out. Empty except on seams.
using seam_points = std::vector<std::vector<point>>;

// A piece of a cut domain.
struct piece_shape {
  // Domain of the piece, as check_domain leaves domains: oriented, with sides and regions.
  domain shape;
  std::vector<std::size_t> edge_of;  // by segment of the shape: the edge of the cut
  prescribed_divisions divisions;    // by segment; of seams alone
};

// Returns the piece of the domain. Vertices and edges keep their order.
piece_shape shape_of_piece(const domain& d, const domain_cut& cut, const seam_points& points,
                           piece_index piece);

}  // namespace asterism::internal
