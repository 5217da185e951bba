// SPDX-License-Identifier: MIT
//
// Chooses the points that divide seams before any piece is meshed, and adds points where a piece
// had to split a subsegment of a seam.
#pragma once

#include <cstddef>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/pieces/piece_shape.hpp"

namespace asterism::internal {

// Divides the seams by metric length, as a fill divides segments. Where the domain has so many
// vertices that a fill spreads sites by its features, points of seams near these features are
// closer, too. Fails where the field does.
result<seam_points> divide_seams(const domain& d, const domain_cut& cut, const metric_field& field);

// A seam in the mesh of one of its pieces: all points, in the edge's own direction.
struct seam_in_mesh {
  std::size_t edge = 0;
  std::vector<point> points;
};

// Returns the seams of a piece that its mesh divides otherwise than the shape prescribes. Fails if
// a prescribed point is missing.
result<std::vector<seam_in_mesh>> seams_asked_for(const domain_cut& cut, const piece_shape& piece,
                                                  piece_index number, const mesh& m);

// Adds the points that the pieces of one round need, in their order, to the present ones. Between
// two present points only the first piece's are added. Returns the edges with new points,
// ascending.
std::vector<std::size_t> unite_seams(const std::vector<seam_in_mesh>& asked, seam_points& points);

}  // namespace asterism::internal
