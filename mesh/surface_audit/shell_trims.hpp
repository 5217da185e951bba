// SPDX-License-Identifier: MIT
//
// Declares what is proved of the borders of trimmed patches: the polygons that stand for curves.
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

// Returns the domain that the plane mesh of a face of a trimmed patch is to be of: the polygons
// through the given sites, curve by curve. The marker of a segment is its curve's number, from 1.
// Fails where a site's place is none of its loops, or one stands twice.
result<domain> polygons_of(const surface_patch& patch, const shell_face& face);

bool is_trimmed(const surface& s);

// Returns the regions that the plane meshes cover, and where each triangle in space is from.
trim_scene trims_of_shell(const surface& s, const surface_shell& shell,
                          const std::vector<shell_triangle>& triangles,
                          const std::vector<patch_spans>& spans);

// Bounds how far the polygons are from the curves, and the two curves of an edge from each other.
// The planes must be without finding.
void audit_trims(const surface& s, const surface_shell& shell,
                 const std::vector<bezier_piece>& pieces, double negligible,
                 const shell_question& asked, shell_report& report);

}  // namespace asterism::internal
