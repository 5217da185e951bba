// SPDX-License-Identifier: MIT
//
// Audits the plane mesh of each face of a shell.
#pragma once

#include "asterism/core/result.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface_audit/shell_report.hpp"

namespace asterism::internal {

// Returns the domain that the plane mesh of a face must cover: the patch's rectangle, with the
// given sites on its sides. Fails if a given site is on no side, or corners are not the patch's.
result<domain> rectangle_of(const surface_patch& patch, const shell_face& face);

// Audits the plane mesh of each face against the domain that it must cover.
void audit_planes(const surface& s, const surface_shell& shell, const shell_question& asked,
                  shell_report& report);

}  // namespace asterism::internal
