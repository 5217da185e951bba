// SPDX-License-Identifier: MIT
//
// Makes all stars at once where all sites have the same metric.
//
// The stars are then those of one triangulation, the constrained Delaunay triangulation in that
// metric. In a triangulation that has all subsegments, where no other edge has to be flipped, no
// site that a site v sees is inside the circle of a triangle at v (Lee and Lin, Generalized
// Delaunay triangulation for planar graphs, 1986; ties count as edge_test breaks them, which is to
// perturb the heights of the lifted sites). So one question for each edge replaces those for each
// star and each site around.
#pragma once

#include <optional>
#include <vector>

#include "asterism/mesh/data/mesh.hpp"
#include "asterism/mesh/stars/star_confirmation.hpp"
#include "asterism/mesh/stars/star_construction.hpp"
#include "asterism/mesh/stars/star_oracle.hpp"
#include "asterism/mesh/support/cancellation.hpp"

namespace asterism::internal {

// Returns the triangles of all these stars, which agree, in the order of triangles_of_consistent();
// none where stars_of_equal_metrics() returns none. If stars are confirmed by_auditor, the edges
// are not tested again after the exact flips.
std::optional<std::vector<triangle>> triangles_of_equal_metrics(const site_oracle& oracle,
                                                                const cancellation& cancelled,
                                                                star_confirmation confirmed);

// Returns the star of each site, all settled and final; none where metrics differ, or where the
// triangulation was not finished or not proved: then stars are to be constructed one by one. The
// same for any number of threads.
std::optional<std::vector<constructed_star>> stars_of_equal_metrics(const site_oracle& oracle,
                                                                    const cancellation& cancelled);

}  // namespace asterism::internal
