// SPDX-License-Identifier: MIT
//
// Audits the edges and vertices of a shell.
#pragma once

#include <vector>

#include "asterism/mesh/data/surface.hpp"
#include "asterism/mesh/data/surface_shell.hpp"
#include "asterism/mesh/surface_audit/shell_report.hpp"
#include "asterism/mesh/surface_audit/shell_triangles.hpp"

namespace asterism::internal {

// Compares edges and vertices of the shell with each other and with the sides of the patches.
void audit_edges(const surface& s, const surface_shell& shell,
                 const std::vector<shell_triangle>& triangles, const shell_question& asked,
                 shell_report& report);

}  // namespace asterism::internal
