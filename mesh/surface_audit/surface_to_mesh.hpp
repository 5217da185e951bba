// SPDX-License-Identifier: MIT
//
// Bounds the distance of the surface from a mesh.
#pragma once

#include <optional>

#include "asterism/mesh/surface_audit/deviation_report.hpp"
#include "asterism/mesh/surface_audit/deviation_scene.hpp"
#include "asterism/mesh/surface_audit/hull_bounds.hpp"
#include "asterism/mesh/surface_audit/narrowing.hpp"

namespace asterism::internal {

// Returns approximately the nearest triangle to a point, in doubles; `hint` is a triangle to begin
// with.
struct nearest_triangle {
  std::uint32_t triangle = 0;
  double squared_distance = 0;
};
nearest_triangle nearest_triangle_to(const deviation_scene& scene, const plain_vector& p,
                                     std::uint32_t hint);

// Returns the triangles a and b of the mesh as a pair with a common edge; none if no edge of a has
// the same two ends, by place, as an edge of b.
std::optional<two_triangles> joined_triangles(const deviation_scene& scene, std::uint32_t a,
                                              std::uint32_t b);

// Returns bounds of the greatest distance of a point of the surface from the mesh.
one_sided_distance from_surface(const deviation_scene& scene, const narrowing_limits& limits);

}  // namespace asterism::internal
