// SPDX-License-Identifier: MIT
//
// Bounds the distance of a mesh from the surface.
#pragma once

#include "asterism/mesh/surface_audit/deviation_report.hpp"
#include "asterism/mesh/surface_audit/deviation_scene.hpp"
#include "asterism/mesh/surface_audit/narrowing.hpp"

namespace asterism::internal {

// Returns bounds of the greatest distance of a point of the mesh from the surface.
one_sided_distance from_mesh(const deviation_scene& scene, const narrowing_limits& limits);

// Returns an upper bound of the greatest distance of a point of the mesh from the surface.
double distance_of_mesh(const deviation_scene& scene, const narrowing_limits& limits);

// Returns an upper bound of the distance of the points of one triangle from the surface.
double distance_of_triangle(const deviation_scene& scene, std::uint32_t triangle,
                            const narrowing_limits& limits);

}  // namespace asterism::internal
