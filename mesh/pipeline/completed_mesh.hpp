// SPDX-License-Identifier: MIT
//
// Completes a mesh that was read from a format without a place for all parts of a mesh, so that it
// can be compared with its certificate.
#pragma once

#include <string>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Takes from the domain the parts that the file has no place for: the number of given vertices, the
// subsegments in the order of the segments, their markers, and regions where the mesh has none. The
// result is a proposal: the auditor judges it, and a certificate's fingerprint identifies the mesh.
//
// Fails, in half a sentence, where the mesh contradicts the domain: its first vertices are others;
// no edges lead along a segment; an edge that it lists is on no segment; or edges that it lists
// under one marker are on segments of several. Requires a domain that check_domain accepted.
result<mesh> completed_by(const domain& d, mesh m);

}  // namespace asterism::internal
