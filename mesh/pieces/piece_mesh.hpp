// SPDX-License-Identifier: MIT
//
// Meshes one piece of a cut domain, and judges it.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pieces/piece_shape.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism::internal {

// Makes the mesh of a piece in the metric wanted, and audits it. Divides seams as prescribed, and
// further where the piece needs it. The metric is not changed: a delivered metric would differ
// between pieces. Requires a size; the options are otherwise those of make_certified_mesh, and so
// are the failures.
result<certified_mesh> make_piece_mesh(const piece_shape& piece, const metric_field& field,
                                       const mesh_options& options,
                                       const progress_listener& progress = {});

}  // namespace asterism::internal
