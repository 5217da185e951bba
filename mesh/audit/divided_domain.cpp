// SPDX-License-Identifier: MIT
#include "asterism/mesh/audit/divided_domain.hpp"

#include <algorithm>

#include "asterism/mesh/audit/checks.hpp"

namespace asterism::internal {

// Runs the checks of a mesh on the boundary alone. Takes out the one finding that a mesh without
// triangles always has.
audit_report audit_divided_domain(const domain& d, const std::vector<point>& vertices,
                                  const std::vector<boundary_edge>& parts) {
  using namespace audit_detail;
  mesh outline;
  for (const point& q : vertices) outline.sites.push_back({q, {1, 0, 1}});
  outline.given = static_cast<vertex_index>(std::min(d.vertices.size(), vertices.size()));
  outline.boundary = parts;
  audit_options asked;
  asked.original = &d;
  audit_report report;
  audit_context context(outline, asked, report);
  check_values(context);
  report.found[static_cast<std::size_t>(finding_kind::empty_mesh)] = 0;
  std::erase_if(report.findings,
                [](const audit_finding& f) { return f.kind == finding_kind::empty_mesh; });
  check_boundary_contacts(context);
  if (report.total_found() == 0) check_winding(context);
  check_domain_kept(context);
  report.certified = report.total_found() == 0;
  return report;
}

}  // namespace asterism::internal
