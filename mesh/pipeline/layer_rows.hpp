// SPDX-License-Identifier: MIT
//
// Adds the first row of vertices of boundary layers as vertices of the domain.
//
// A metric alone leaves the height of the first cell to chance: edges of a mesh are between 0.7 and
// 1.4 long in it, and so are heights. A vertex of the domain at the height asked for is one of the
// mesh.
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/metric/size_wishes.hpp"

namespace asterism {

// Returns the domain with a vertex at the height of the first layer over the middle of each piece
// that a side with layers will be divided into, in this metric. `d` as check_domain leaves it,
// `field` with the layers in it. Leaves out vertices that would be outside, nearer than nine
// tenths of the height to another segment, or nearer than 0.7 in the metric to another vertex: in
// corners and in gaps two layers have no room. At most `most` are added. Fails where the field
// does.
ASTERISM_EXPORT result<domain> with_layer_rows(domain d, const size_wishes& wishes,
                                               const metric_field& field, std::size_t most);

}  // namespace asterism
