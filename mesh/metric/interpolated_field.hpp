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
// the tensor is the vertex's own, bit for bit. A point outside all triangles, for instance by
// rounding, gets about the tensor of the nearest point of the nearest triangle; of several
// triangles that may contain a point the one with the greatest least weight is taken, and of equals
// the first. Keeps its own copy. Requirements are those of adopt_mesh; flat and clockwise triangles
// are left out, and there must be at least one other. Divides all tensors by size^2, as
// make_metric_field does.
ASTERISM_EXPORT std::unique_ptr<metric_field> make_interpolated_field(const mesh& m,
                                                                      double size = 1);

// Former name of the function above.
inline std::unique_ptr<metric_field> make_sampled_field(const mesh& m, double size = 1) {
  return make_interpolated_field(m, size);
}

}  // namespace asterism
