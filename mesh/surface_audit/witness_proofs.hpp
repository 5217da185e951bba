// SPDX-License-Identifier: MIT
//
// Proves a lower bound of the distance of a witness.
#pragma once

#include "asterism/mesh/surface_audit/deviation_report.hpp"
#include "asterism/mesh/surface_audit/deviation_scene.hpp"

namespace asterism::internal {

// Returns a proved lower bound of the distance of a point of the mesh from all of the surface,
// `proposed` or little less; 0 if none is proved.
double proved_distance_of_mesh_point(const deviation_scene& scene, const deviation_witness& at,
                                     double proposed);
// Returns a proved lower bound of the distance of a point of the surface from all of the mesh,
// `proposed` or little less; 0 if none is proved. Computes exactly where intervals do not decide
// and the patch is a Bezier patch, whose control points are doubles.
double proved_distance_of_surface_point(const deviation_scene& scene, const surface_place& at,
                                        double proposed);

}  // namespace asterism::internal
