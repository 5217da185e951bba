// SPDX-License-Identifier: MIT
//
// Proves of a witness how far it is at least.
#pragma once

#include "asterism/mesh/surface_audit/deviation_report.hpp"
#include "asterism/mesh/surface_audit/deviation_scene.hpp"

namespace asterism::internal {

// Returns a distance, `proposed` or little less, that the point of the mesh provably has from all
// of the surface, else 0.
double proved_distance_of_mesh_point(const deviation_scene& scene, const deviation_witness& at,
                                     double proposed);
// The same for a point of the surface and all of the mesh. Exact where intervals do not decide and
// the patch is a Bezier patch, whose control points are doubles.
double proved_distance_of_surface_point(const deviation_scene& scene, const surface_place& at,
                                        double proposed);

}  // namespace asterism::internal
