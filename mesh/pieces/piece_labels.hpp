// SPDX-License-Identifier: MIT
//
// Assigns the triangles of a coarse mesh to pieces.
#pragma once

#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/pieces/cut_wishes.hpp"

namespace asterism::internal {

// Returns the piece of each triangle. Halves the triangles again and again, across that one of
// eight directions where the cut is shortest as the metric measures, into parts of equal area in
// it; then triangles change sides where that makes cuts shorter and keeps areas within some
// percent. In doubles, in a fixed order. Fails where the field does.
result<std::vector<piece_index>> label_triangles(const mesh& coarse, const metric_field& field,
                                                 std::size_t pieces);

}  // namespace asterism::internal
