// SPDX-License-Identifier: MIT
//
// Splits the inner edges of a certified mesh that join two vertices of the boundary
// (mesh/audit/split_edges.hpp), and certifies the mesh that results.
#pragma once

#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::internal {

// Gives each such edge a vertex in its middle, makes stars agree about the new triangles, and
// repeats that until there are no such edges. The mesh is delivered in a metric that may differ
// from `field` there, as any mesh made by local changes is. If this does not end in a certified
// mesh, the mesh stays unchanged, and the outcome is not complete, with a reason. A mesh that is
// not certified before stays unchanged, too. Edges of the boundary may be split, where stars need
// it.
certified_mesh split_across(certified_mesh made, const domain& d, const metric_field& field,
                            const mesh_options& options);

}  // namespace asterism::internal
