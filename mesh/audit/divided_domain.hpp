// SPDX-License-Identifier: MIT
//
// Decides whether the segments of a domain, divided at further points, still are its boundary.
//
// Proves point 2 of an audit for a boundary without a mesh: the parts meet in common ends only,
// wind once around what is on their left, and lead along each segment from its start to its end,
// straight but for rounding.
#pragma once

#include <vector>

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/data/domain.hpp"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism::internal {

// Audits the parts. `vertices` are the domain's in their order, then those that divide segments.
// The report is certified if nothing was found.
audit_report audit_divided_domain(const domain& d, const std::vector<point>& vertices,
                                  const std::vector<boundary_edge>& parts);

}  // namespace asterism::internal
