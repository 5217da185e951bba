// SPDX-License-Identifier: MIT
//
// Proves that the polygons which replace the curves of trimmed patches are near them.
#pragma once

#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface_audit/shell_report.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"
#include "asterism/mesh/surface_audit/trimmed_places.hpp"

namespace asterism::internal {

// Returns the domain that the plane mesh of a trimmed face must cover: the polygons through the
// given sites, curve by curve. The marker of a segment is its curve's number, from 1. Fails if a
// site's place is not on its loops, or one occurs twice.
result<domain> polygons_of(const surface_patch& patch, const shell_face& face);

bool is_trimmed(const surface& s);

// Returns the regions that the plane meshes cover, and the origin of each triangle in space.
trim_scene trims_of_shell(const surface& s, const surface_shell& shell,
                          const std::vector<shell_triangle>& triangles,
                          const std::vector<patch_spans>& spans);

// Bounds the distances of the polygons from the curves, and of the two curves of an edge from each
// other. The plane meshes must have no finding.
void audit_trims(const surface& s, const surface_shell& shell,
                 const std::vector<bezier_piece>& pieces, double negligible,
                 const shell_question& asked, shell_report& report);

}  // namespace asterism::internal
