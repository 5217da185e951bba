// SPDX-License-Identifier: MIT
//
// Transfers a solution from the vertices of one mesh to the vertices of another mesh of the same
// domain.
#pragma once

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/solution.hpp"
#include "asterism/mesh/transfer/transferred_solution.hpp"

namespace asterism {

// Methods of transfer.
// interpolate: the value of the old field at the new vertex. Keeps linear fields to rounding; makes
//              no new extrema; changes integrals.
// project:     the nearest field in the mean square, over the common parts of old and new
//              triangles. Keeps integrals and linear fields to rounding; may overshoot.
// bounded:     the projection with added diffusion, so that the value at each vertex stays within
//              the old values around it. Keeps integrals to rounding; makes no new extrema.
enum class transfer_method { interpolate, project, bounded };

// Transfers all fields, tensors entry by entry. Requires triangulations of domains that differ by
// little: new triangles that are partly outside the old mesh take the interpolated values, and are
// counted. No value is read across a gap: a vertex outside gets its value from the triangles joined
// to those of its neighbours. Fails where a part of the new mesh does not touch the old one, for a
// solution that is not on `from`, and where an area or an integral exceeds the doubles. If places
// or values are scaled by powers of two, the outcome is scaled likewise. Time and memory are linear
// in the triangles and their common parts; parallel, the same for any number of threads.
ASTERISM_EXPORT result<transferred_solution> transfer_solution(const mesh& from,
                                                               const solution& values,
                                                               const mesh& to, transfer_method how);

}  // namespace asterism
