// SPDX-License-Identifier: MIT
//
// Returns the texts of `verify` and `certify` on an audit, the same for both.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "asterism/mesh/audit/audit_report.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/audit/region_areas.hpp"
#include "asterism/mesh/audit/theorem_report.hpp"

namespace asterism::apps {

// Returns the number of findings of each kind that an audit keeps: all with --all-findings.
std::size_t findings_kept(bool all);

// Writes the findings, the first ten of each kind or all that were kept, a line each, and the
// number of further ones.
void write_findings(std::ostream& out, const audit_report& report);

// Returns the text of the worst angle; `degrees` is 180 where all triangles have exempt
// corners.
std::string worst_angle_text(double degrees);
// Returns "worst angle 20.10 degrees", with exempt and collateral angles if there are any.
std::string angles_text(const audit_report& report);

// Returns "; points of split segments off them by up to 3.3e-16 (1.5 ulps)"; empty up to one ulp.
std::string deviation_text(const audit_report& report);
// Returns a clause on the distance of the boundary from the domain's curves; empty if it has none.
std::string curves_text(const audit_report& report);
// Returns a clause on the distance of the boundary from the former one, as the certificate has it
// and verify() compared it; empty where there is none.
std::string former_text(const std::optional<certificate>& claim);

// Returns "; periodic: " and how the sides match that must have the same points; empty where there
// are none.
std::string periodic_text(const std::vector<periodic_match>& matches);

// Returns "areas of regions before and after: 1 (0.25, 0.25), 3 (0.75, 0.75)", for the first ten;
// the areas before are those in the domain where no mesh was adapted. Empty where region 1 is the
// only one.
std::string regions_text(const std::vector<region_area>& regions);

// Returns "not all stars were looked at, as ...", where the audit ended after the first
// findings.
std::string cut_short_text(const audit_report& report);

// Returns "applies: at sigma eps 0.013 angles of 27.25 degrees are proved", or why it does not.
std::string theorem_text(const theorem_hypotheses& measured);

// Returns "; dual of the Voronoi diagram: proved", if the question includes that.
std::string voronoi_text(const audit_report& report);

}  // namespace asterism::apps
