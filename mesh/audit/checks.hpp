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

// Check points 0 to 2 and the regions of a mesh that differs from one that was checked in these
// changes, and in tensors. The context has the lists of the other mesh; those of edges and fans are
// updated. What they do not check is as it was (docs/math/certificate.md, sections 1 and 2). Each
// requires that the ones before found nothing.
void check_values_again(audit_context& context, const triangulation_changes& changes);
void check_edges_again(audit_context& context, const triangulation_changes& changes);
void check_fans_again(audit_context& context, const triangulation_changes& changes);
void check_regions_again(audit_context& context, const triangulation_changes& changes);

}  // namespace asterism::internal::audit_detail
