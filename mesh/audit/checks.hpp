// SPDX-License-Identifier: MIT
//
// Lists the checks of a mesh in the order of the auditor, each in a source of its own. Each check
// reports findings into the context and returns.
#pragma once

#include "asterism/mesh/audit/context.hpp"

namespace asterism::internal::audit_detail {

void check_values(audit_context& context);
// Checks the same without triangles that are repeated.
void check_input(audit_context& context);
// Checks the numbers of the sites alone, a part of check_input.
void check_sites(audit_context& context);
void check_orientations(audit_context& context);
void check_edges(audit_context& context);
void check_boundary_contacts(audit_context& context);
void check_winding(audit_context& context);
void check_fans(audit_context& context);
void check_domain_kept(audit_context& context);
void check_regions(audit_context& context);
void check_angles(audit_context& context);
void check_something_judged(audit_context& context);
void check_stars(audit_context& context);
void check_voronoi(audit_context& context);

}  // namespace asterism::internal::audit_detail
