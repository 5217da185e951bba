// SPDX-License-Identifier: MIT
//
// Proves a lower bound of the distance of a witness.
#pragma once

#include "asterism/mesh/surface_audit/deviation_report.hpp"
#include "asterism/mesh/surface_audit/deviation_scene.hpp"

namespace asterism::internal {

// Returns a distance, `proposed` or little less, that the point of the mesh provably has from all
// of the surface, else 0.
double proved_distance_of_mesh_point(const deviation_scene& scene, const deviation_witness& at,
                                     double proposed);
// Returns such a distance of a point of the surface from all of the mesh. Exact where intervals do
// not decide and the patch is a Bezier patch, whose control points are doubles.
double proved_distance_of_surface_point(const deviation_scene& scene, const surface_place& at,
                                        double proposed);

}  // namespace asterism::internal
