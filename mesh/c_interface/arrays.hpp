// SPDX-License-Identifier: MIT
//
// Makes domains, meshes and metric fields from the arrays of C and Python programs.
#pragma once

#include <cstddef>
#include <memory>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/c_interface/mesh.h"
#include "asterism/mesh/data/bounding_box.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/pipeline/foreign_mesh.hpp"

namespace asterism::internal {

// Makes the domain of arrays, not checked beyond null pointers: check_domain does the rest.
result<domain> domain_of(const asterism_domain& arrays);

// Makes the metric field. `box` is that of the domain.
result<std::unique_ptr<metric_field>> field_of(const asterism_metric& metric,
                                               const bounding_box& box);

// A view of `count` rows of numbers, `stride` apart.
struct number_rows {
  std::size_t count;
  const double* first;
  std::size_t stride;
};
struct triangle_rows {
  std::size_t count;
  const unsigned* first;
};

// Makes the mesh, with one tensor for each vertex. Fails, naming the offender, where adopt_mesh
// does.
result<adopted_mesh> mesh_of(const number_rows& places, const number_rows& tensors,
                             const triangle_rows& triangles);

}  // namespace asterism::internal
