// SPDX-License-Identifier: MIT
//
// Makes a mesh in which pairs of sides of the boundary have the same points, for functions that are
// periodic, and judges it.
//
//   const auto made = make_periodic_mesh(square, field, options, {{4, 2}, {1, 3}});
//   for (const periodic_match& match : made.value().claim.periodic) say(text_of(match));
//
// Sides are divided once by metric length, in the finer of the metrics on both. Where a mesh needs
// more points on one side, they are put on both sides, and it is made again, until both sides of
// all pairs agree (docs/math/periodic.md).
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/periodic_match.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/metric_field.hpp"
#include "asterism/mesh/data/options.hpp"
#include "asterism/mesh/pipeline/certified_mesh.hpp"

namespace asterism {

// Makes the mesh; without pairs, that of make_certified_mesh. Requirements and failures are those
// of make_certified_mesh. Fails, too, with a sentence that names both markers, where two sides
// cannot match: if one is no line with two ends, is part of a curve, or is not the other one
// shifted or turned; and for darts. The certificate has the pairs, and how they match as
// match_periodic found; a mesh in which they do not is not complete. Where a number of vertices is
// wanted of a metric that is given at the nodes of a mesh, sides are divided in edges of the length
// with which the domain takes that number. With `no_split_across` no inner edge of a complete mesh
// joins two vertices of the boundary, with pairs or without; where split_across() does not achieve
// that, the mesh is not complete.
ASTERISM_EXPORT result<certified_mesh> make_periodic_mesh(const domain& d,
                                                          const metric_field& field,
                                                          const mesh_options& options,
                                                          const std::vector<periodic_pair>& pairs,
                                                          const progress_listener& progress = {},
                                                          bool no_split_across = false);

// Returns an error where the sides of the domain cannot match, or a marker is of two pairs.
ASTERISM_EXPORT std::optional<error> check_periodic(const domain& d,
                                                    const std::vector<periodic_pair>& pairs);

// Adds to the certificate the pairs and how they match. A mesh in which they do not is not
// complete.
ASTERISM_EXPORT void claim_periodic(const std::vector<periodic_pair>& pairs,
                                    certified_mesh& judged);

}  // namespace asterism
