// SPDX-License-Identifier: MIT
//
// Checks that the chords of a mesh follow the curves of its domain (theorem 7 of
// docs/math/proof-format.md). Part of check_proof().
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal::proof_detail {

// The part of the boundary that belongs to no curve: edges of the mesh, segments of the domain.
struct straight_part {
  std::vector<boundary_edge> edges;
  std::vector<segment> segments;
};

// Assigns to each curve a chain along it, no chain twice, and returns the rest of the boundary.
// `number_of` maps each vertex of the domain to its number among the distinct ones, which are the
// first `given` of the mesh. Fails if a curve has no chain within the tolerance, if a required
// vertex is not the domain's, or if a vertex of the domain that is on no curve is not required.
result<straight_part> part_off_curves(const plane& all, const proof_question& asked,
                                      const std::vector<vertex_index>& number_of,
                                      std::size_t given);

}  // namespace asterism::internal::proof_detail
