// SPDX-License-Identifier: MIT
//
// Makes the coarse mesh along whose edges a domain is cut.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/pieces/cut_wishes.hpp"

namespace asterism::internal {

// Returns a mesh of the domain, in the metric, whose triangles are larger than those wanted
// by a power of two: about a hundred a piece if the mesh has that many, else fewer. It is
// proved to be a triangulation of the domain; its stars need not agree. Fails as cut_domain
// does.
result<mesh> make_coarse_mesh(const domain& d, const metric_field& field, const cut_wishes& wishes);

}  // namespace asterism::internal
