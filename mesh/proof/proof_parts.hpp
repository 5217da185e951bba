// SPDX-License-Identifier: MIT
//
// Declares the parts of check_proof(), in their order. Each returns what is not shown.
#pragma once

#include <optional>
#include <string>

#include "asterism/mesh/proof/check_proof.hpp"
#include "asterism/mesh/proof/plane.hpp"

namespace asterism::internal::proof_detail {

inline error not_shown(std::string what) { return {std::move(what), error_code::invalid_mesh}; }
inline std::string vertex_number(std::size_t v) { return "vertex " + std::to_string(v + 1); }

// Theorem 1: the triangles fill the rectangle, and the edges listed are the mesh's.
std::optional<error> check_filled(const plane& all);
// Point 2 against the domain: its vertices, its segments, its holes and regions; without one, that
// triangles with no segment between them have one region.
std::optional<error> check_shape(const plane& all, const proof_question& asked,
                                 const mesh_proof& proof);
// Point 3.
std::optional<error> check_corners(const plane& all, const proof_question& asked);

}  // namespace asterism::internal::proof_detail
