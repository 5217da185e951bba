// SPDX-License-Identifier: MIT
//
// Checks that chords of a mesh lead along the curves of its domain (theorem 7 of
// docs/math/proof-format.md). Part of check_proof().
#pragma once

#include <optional>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/proof/plane.hpp"
#include "asterism/mesh/proof/proof_question.hpp"

namespace asterism::internal::proof_detail {

// Holds the part of the boundary that is of no curve: edges of the mesh, segments of the domain.
struct straight_part {
  std::vector<boundary_edge> edges;
  std::vector<segment> segments;
};

// Takes for each curve a chain along it, no chain twice, and returns what is left. `number_of` is
// the number of each vertex of the domain among the distinct ones, which are the first `given` of
// the mesh. Fails where a curve has no chain within the tolerance, and where other vertices are
// required than the domain's, or fewer than those that are on no curve.
result<straight_part> part_off_curves(const plane& all, const proof_question& asked,
                                      const std::vector<vertex_index>& number_of,
                                      std::size_t given);

}  // namespace asterism::internal::proof_detail
