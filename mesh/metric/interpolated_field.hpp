// SPDX-License-Identifier: MIT
//
// Interpolates a metric field that is given at the vertices of a mesh.
#pragma once

#include <memory>

#include "asterism/core/export.h"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"

namespace asterism {

// Returns the field that interpolates the metrics of a mesh. Between the vertices of a triangle
// logarithms are interpolated linearly ("log-Euclidean", numerics/metric_algebra.hpp); at a vertex
// the tensor is the vertex's own, bit for bit. A point outside all triangles, as rounding puts
// some, gets what the nearest point of the nearest triangle in its surroundings has, about; where
// several triangles could have a point the one it is farthest inside of is taken, and of equals the
// first. Keeps its own copy. Requires what adopt_mesh does; triangles that are flat or clockwise
// are left out, and there must be one that is not. All tensors are divided by size^2, as
// make_metric_field does.
ASTERISM_EXPORT std::unique_ptr<metric_field> make_interpolated_field(const mesh& m,
                                                                      double size = 1);

// The same, by the name that the function had before.
inline std::unique_ptr<metric_field> make_sampled_field(const mesh& m, double size = 1) {
  return make_interpolated_field(m, size);
}

}  // namespace asterism
